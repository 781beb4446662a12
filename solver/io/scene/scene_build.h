/* From the structs that a tree fills to struct mpm_scene, with the checks that need more than one
 * key.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_SCENE_BUILD_H
#define MPM_IO_SCENE_BUILD_H

#include "io/scene/scene_schema.h"

enum { MPM_PATH_SIZE = 256 };

/* What the building of a scene needs to know. */
struct mpm_reading {
    struct mpm_scene *scene;
    const struct mpm_tree_node *root; /* checked, with defaults: knows the lines */
    const struct mpm_raw_scene *raw;
    struct mpm_faults *faults;
    struct mpm_error *error; /* the mistake in hand */
};

/* What messages call the scene's places by. */
static inline struct mpm_source mpm_scene_source(const struct mpm_scene *scene)
{
    return (struct mpm_source){.path = scene->path,
                               .what = "scene file",
                               .settings = (const char *const *)scene->settings};
}

/* Each fills its part of reading->scene, in this order; what a failure leaves behind is
 * freed with the scene. */
enum mpm_status mpm_build_general(const struct mpm_reading *reading);
/* A part of it: stress update, form and transfer. */
enum mpm_status mpm_build_transfer(const struct mpm_reading *reading);
enum mpm_status mpm_build_materials(const struct mpm_reading *reading);
/* A part of it: the law's parameters, by enum mpm_parameter; `path` is that of the material. */
enum mpm_status mpm_build_parameters(const struct mpm_reading *reading, const char *path,
                                     const struct mpm_material_law *law,
                                     const struct mpm_raw_material *raw, double *parameter);
enum mpm_status mpm_build_bodies(const struct mpm_reading *reading);
enum mpm_status mpm_build_boundaries(const struct mpm_reading *reading);
/* A part of it: a plane of symmetry instead of a velocity; `path` is that of the boundary. */
enum mpm_status mpm_build_symmetry(const struct mpm_reading *reading, const char *path,
                                   const struct mpm_raw_boundary *raw,
                                   struct mpm_boundary_spec *boundary);
enum mpm_status mpm_build_loads(const struct mpm_reading *reading);
/* The body of that name, on whose edges there is a load; `path` is that of the name. */
enum mpm_status mpm_build_loaded_body(const struct mpm_reading *reading, const char *path,
                                      const char *text, size_t *body);
/* Cracks, and whether the method takes them. */
enum mpm_status mpm_build_cracks(const struct mpm_reading *reading);
/* A part of it: what holds its surfaces together, once its points are known. */
enum mpm_status mpm_build_cohesive(const struct mpm_reading *reading, const char *path,
                                   const struct mpm_raw_crack *raw, struct mpm_crack_spec *crack);
/* Parts of cracks and contact: what flows across of temperature. `path` is that of the crack, of
 * the pair, or "contact"; `rigid`: one of the pair is. */
enum mpm_status mpm_build_crack_surface(const struct mpm_reading *reading, const char *path,
                                        const struct mpm_raw_crack *raw,
                                        struct mpm_crack_spec *crack);
enum mpm_status mpm_build_pair_surface(const struct mpm_reading *reading, const char *path,
                                       const struct mpm_raw_contact_pair *raw, bool rigid,
                                       struct mpm_pair_spec *pair);
/* Once pairs are listed: does one use what contact itself says of heat? */
enum mpm_status mpm_check_pair_surfaces(const struct mpm_reading *reading);
bool mpm_surfaces_agree(const struct mpm_surface_spec *one, const struct mpm_surface_spec *other);
/* Contact between bodies. */
enum mpm_status mpm_build_contact(const struct mpm_reading *reading);
/* The velocity field that cracks cut, where bodies have several. */
enum mpm_status mpm_build_cracked_field(const struct mpm_reading *reading);
/* Scalars that are conducted, once all that is about motion is read: scenes at rest have none. */
enum mpm_status mpm_build_transport(const struct mpm_reading *reading);
/* Damping, and when a run is at rest. */
enum mpm_status mpm_build_damping(const struct mpm_reading *reading);

/* A part of the output: places whose fields are written. */
enum mpm_status mpm_build_probes(const struct mpm_reading *reading);

/* Their J integrals. */
enum mpm_status mpm_build_j_integrals(const struct mpm_reading *reading);

/* Regions; `path` is that of the key `region`. */
enum mpm_status mpm_build_body_region(const struct mpm_reading *reading, const char *path,
                                      const struct mpm_raw_body_region *raw,
                                      struct mpm_region *region);
enum mpm_status mpm_build_boundary_region(const struct mpm_reading *reading, const char *path,
                                          const struct mpm_raw_boundary_region *raw,
                                          struct mpm_region *region);

/* A place in a region, off its centre, where formulas such as x/sqrt(x^2+y^2) have values. */
void mpm_region_sample(const struct mpm_scene *scene, const struct mpm_region *region,
                       double place[2]);

/* Checks and copies a pair of expressions: they parse and are finite at `place` and t = 0.
 * `free` becomes NULL. */
enum mpm_status mpm_build_expressions(const struct mpm_reading *reading, const char *path,
                                      char *const texts[2], bool has_time, const double place[2],
                                      struct mpm_vector_expression *vector);

/* An expression that is this number everywhere and at all times costs a step nothing: becomes NULL.
 */
void mpm_drop_constant(char **text, double idle);

/* The same for one text; *value at `place` and t = 0. */
enum mpm_status mpm_build_expression(const struct mpm_reading *reading, const char *path,
                                     const char *text, bool has_time, const double place[2],
                                     char **copy, double *value);

/* ------------------------------------------------------------------- tools */

/* MPM_BAD_INPUT with the place of the key at `path`, or of the nearest around it; with the
 * --set, if one gave a part of it. */
enum mpm_status mpm_reading_fault(const struct mpm_reading *reading, const char *path,
                                  const char *format, ...) __attribute__((format(printf, 3, 4)));

/* A mistake is noted and MPM_OK returned: the next part can be built all the same. */
enum mpm_status mpm_reading_note(const struct mpm_reading *reading, enum mpm_status status);

/* Does the scene or a --set give this key, not only a default? */
bool mpm_reading_given(const struct mpm_reading *reading, const char *path);

/* Line of the key in the file; 0 if it is not from there. */
int mpm_reading_line(const struct mpm_reading *reading, const char *path);

/* The path of a key; as an argument, mpm_path_join(path, "region").text lives until the call is
 * over. */
struct mpm_path {
    char text[MPM_PATH_SIZE];
};
/* "bodies.3.region" */
struct mpm_path mpm_path_join(const char *path, const char *key);
/* "bodies.3" */
struct mpm_path mpm_path_entry(const char *list, size_t position);

/* The number that the checks found in a text; 0 for NULL. */
double mpm_raw_double(const char *text);

/* calloc: `array` is the address of a pointer to elements of `size` bytes.
 * MPM_ENVIRONMENT_FAILED: no memory, and the pointer is NULL. */
enum mpm_status mpm_reading_allocate(const struct mpm_reading *reading, size_t count, size_t size,
                                     const char *what, void *array);

/* Refuses names of a list's entries that repeat; they are `stride` bytes apart from `first` on. */
enum mpm_status mpm_reading_check_names(const struct mpm_reading *reading, const char *list,
                                        size_t count, const char *first, size_t stride);

/* A copy of a text. */
enum mpm_status mpm_reading_copy(const struct mpm_reading *reading, const char *text, char **copy);

#endif
