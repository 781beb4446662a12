/* Dimensions of physical quantities. Part of the public interface: mpm.h includes it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_DIMENSION_H
#define MPM_DIMENSION_H

#include "mpm_api.h"

#include <stdint.h>

MPM_API_BEGIN

/* Exponents of the unit of a quantity: of stress -1, 1, -2 and 0. */
struct mpm_dimension {
    int8_t length, mass, time, temperature;
};
/* clang-format off */
#define MPM_DIMENSION_NONE             {.length = 0}
#define MPM_DIMENSION_LENGTH           {.length = 1}
#define MPM_DIMENSION_AREA             {.length = 2}
#define MPM_DIMENSION_FORCE            {.length = 1, .mass = 1, .time = -2}
#define MPM_DIMENSION_VOLUME           {.length = 3}
#define MPM_DIMENSION_MASS             {.mass = 1}
#define MPM_DIMENSION_TIME             {.time = 1}
#define MPM_DIMENSION_TEMPERATURE      {.temperature = 1}
#define MPM_DIMENSION_EXPANSION        {.temperature = -1}
#define MPM_DIMENSION_RATE             {.time = -1}
#define MPM_DIMENSION_VELOCITY         {.length = 1, .time = -1}
#define MPM_DIMENSION_ACCELERATION     {.length = 1, .time = -2}
#define MPM_DIMENSION_DENSITY          {.length = -3, .mass = 1}
#define MPM_DIMENSION_MOMENTUM         {.length = 1, .mass = 1, .time = -1}
#define MPM_DIMENSION_ANGULAR_MOMENTUM {.length = 2, .mass = 1, .time = -1}
#define MPM_DIMENSION_STRESS           {.length = -1, .mass = 1, .time = -2}
#define MPM_DIMENSION_ENERGY           {.length = 2, .mass = 1, .time = -2}
#define MPM_DIMENSION_SPECIFIC_ENERGY  {.length = 2, .time = -2}
#define MPM_DIMENSION_AREA_RATE        {.length = 2, .time = -1}
#define MPM_DIMENSION_TOUGHNESS        {.mass = 1, .time = -2} /* energy per area */
#define MPM_DIMENSION_STIFFNESS        {.length = -2, .mass = 1, .time = -2} /* stress per length */
#define MPM_DIMENSION_COMPLIANCE       {.length = 1, .mass = -1, .time = 2} /* 1 per stress */
#define MPM_DIMENSION_RATE_SQUARED     {.time = -2}
#define MPM_DIMENSION_HEAT_CAPACITY    {.length = 2, .time = -2, .temperature = -1} /* per mass */
#define MPM_DIMENSION_CONDUCTIVITY     {.length = 1, .mass = 1, .time = -3, .temperature = -1}
#define MPM_DIMENSION_HEAT_FLUX        {.mass = 1, .time = -3} /* per area and time */
#define MPM_DIMENSION_FILM             {.mass = 1, .time = -3, .temperature = -1}
#define MPM_DIMENSION_RADIATION        {.mass = 1, .time = -3, .temperature = -4}
#define MPM_DIMENSION_MASS_FLUX        {.length = -2, .mass = 1, .time = -1}
#define MPM_DIMENSION_MASS_SOURCE      {.length = -3, .mass = 1, .time = -1}
#define MPM_DIMENSION_HEAT_SOURCE      {.length = -1, .mass = 1, .time = -3} /* per volume */
/* clang-format on */

MPM_API_END

#endif
