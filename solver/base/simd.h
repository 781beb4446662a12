/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_BASE_SIMD_H
#define MPM_BASE_SIMD_H
enum { MPM_VECTOR_SIZE = 4 };
#endif
