/* Keys of contact between bodies, as those of scene_keys.h, which includes this.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_CONTACT_KEYS_H
#define MPM_IO_CONTACT_KEYS_H

/* clang-format off */
/* What a law takes; at contact itself they are those of pairs that are not listed. */
#define KEYS_OF_PAIR_LAW(X, S)                                                                     \
    X(S, ONE, friction, NUMBER, ANYWHERE, OPTIONAL, NONE, NULL, AT_LEAST(0),                         \
      "law: friction: coefficient while sliding")                                                  \
    X(S, ONE, static_friction, NUMBER, ANYWHERE, OPTIONAL, NONE, NULL, AT_LEAST(0),                  \
      "law: friction: coefficient below which nothing slides; friction if missing, and at least that") \
    X(S, ONE, adhesion, NUMBER, ANYWHERE, OPTIONAL, STRESS, NULL, AT_LEAST(0),                     \
      "tension that contact bears before it opens; 0 if missing")                                  \
    X(S, ONE, touching, NUMBER, ANYWHERE, OPTIONAL, NONE, NULL, ABOVE_TO(0, 2),                      \
      "detection: volume: areas at a node, over what the node can see, from which bodies touch; 0.9 if missing") \
    X(S, ONE, tension, NUMBER, ANYWHERE, OPTIONAL, STIFFNESS, NULL, AT_LEAST(0),                   \
      "law: interface: D_n where it opens, traction per opening")                                  \
    X(S, ONE, compression, NUMBER, ANYWHERE, OPTIONAL, STIFFNESS, NULL, AT_LEAST(0),               \
      "law: interface: D_n where the bodies overlap; tension if missing")                          \
    X(S, ONE, shear, NUMBER, ANYWHERE, OPTIONAL, STIFFNESS, NULL, AT_LEAST(0),                     \
      "law: interface: D_t, traction per sliding")                                                 \
    X(S, ONE, ratio_limit, NUMBER, ANYWHERE, OPTIONAL, NONE, NULL, AT_LEAST(1),                      \
      "law: interface, normals other than logistic and given: largest ratio of shear to tension or compression, either way; 10 if missing: their errors take opening for sliding, and make energy where bodies turn") \
    X(S, ONE, conductance, NUMBER, ANYWHERE, OPTIONAL, FILM, NULL, AT_LEAST(0),                      \
      "heat: conductance, and only there: heat per area, time and difference of temperatures")     \
    X(S, ONE, heat_gap, NUMBER, ANYWHERE, OPTIONAL, LENGTH, NULL, AT_LEAST(0),                       \
      "of heat with detection: extent and law: friction, stick or frictionless: largest gap that it flows across; 0.01 of the smaller cell side if missing")

#define KEYS_contact_pair(X, S)                                                                    \
    X(S, PAIR, of, NAME, ANYWHERE, REQUIRED, NONE, NULL, ANY,                                        \
      "names of two materials, or of two bodies with fields: bodies; one may be a rigid body")     \
    X(S, CHOICE, law, pair_law, ANYWHERE, REQUIRED, NONE, NULL, ANY,                                 \
      "what they do where they meet: one field (none), one velocity in tension too (bonded), no sliding while pressed (stick), no approach (frictionless), Coulomb friction, imperfect interface") \
    X(S, CHOICE, normal, pair_normal, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                           \
      "where the normal comes from; that of contact if missing")                                   \
    X(S, PAIR, direction, NUMBER, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                               \
      "normal: given: vector from the first to the second, of any length")                         \
    X(S, CHOICE, detection, pair_detection, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                     \
      "when they touch; that of contact if missing")                                               \
    X(S, CHOICE, heat, surface_law, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                             \
      "what flows where they touch; if missing that of contact, with its conductance and heat_gap") \
    KEYS_OF_PAIR_LAW(X, S)

#define KEYS_contact(X, S)                                                                         \
    X(S, CHOICE, fields, contact_fields, ANYWHERE, OPTIONAL, NONE, "materials", ANY,                 \
      "what has a velocity field of its own: each material, or each body")                         \
    X(S, CHOICE, law, pair_law, ANYWHERE, OPTIONAL, NONE, "none", ANY,                               \
      "of pairs that are not listed; with rigid bodies it is none: they drive nodes")              \
    X(S, CHOICE, normal, pair_normal, ANYWHERE, OPTIONAL, NONE, "larger", ANY,                       \
      "where normals come from: gradients of both bodies' areas weighted with them (average), not weighted (area), of volumes, of the body with the larger area, a plane between the particles by linear or logistic regression, or given in pairs") \
    X(S, CHOICE, detection, pair_detection, ANYWHERE, OPTIONAL, NONE, "extent", ANY,                 \
      "when bodies touch: by the gap between the edges of their particles (extent), by the areas at a node (volume), whenever they share a node (shared)") \
    X(S, CHOICE, heat, surface_law, ANYWHERE, OPTIONAL, NONE, "insulated", ANY,                      \
      "with transport.temperature: what flows between deformable bodies that touch: nothing (insulated), all that makes their temperatures one (perfect), conductance times the difference of temperatures") \
    KEYS_OF_PAIR_LAW(X, S)                                                                         \
    X(S, LIST, pairs, contact_pair, ANYWHERE, OPTIONAL, NONE, NULL, ANY, "pairs with a law of their own")

/* clang-format on */

#endif
