/* Cracks of a scene: chains of points that meet neither themselves nor each other, in bodies.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"

#include "base/segment.h"
#include "method/cracks/crack_contact.h"
#include "method/transfer/transfers.h"
#include "model/region.h"

#include <math.h>
#include <string.h>

static double shorter_side(const struct mpm_scene *scene)
{
    return fmin(scene->cell[0], scene->cell[1]);
}

/* ---------------------------------------------------------------- segments */

static struct mpm_segment segment_of(const struct mpm_crack_spec *crack, size_t index)
{
    struct mpm_segment segment;
    memcpy(segment.a, crack->points[index], sizeof segment.a);
    memcpy(segment.b, crack->points[index + 1], sizeof segment.b);
    return segment;
}

static double distance(const double a[2], const double b[2])
{
    return hypot(b[0] - a[0], b[1] - a[1]);
}

/* ------------------------------------------------------------------ places */

static enum mpm_status check_lengths(const struct mpm_reading *reading, const char *path,
                                     const struct mpm_crack_spec *crack)
{
    const double near = MPM_CRACK_NEAR * shorter_side(reading->scene);
    for (size_t i = 0; i + 1 < crack->point_count; i++) {
        const struct mpm_segment s = segment_of(crack, i);
        if (!(distance(s.a, s.b) > near))
            return mpm_reading_fault(reading, path,
                                     "a segment of no length, from point %zu (%g, %g) to the "
                                     "next; allowed: more than %g of the shorter cell side",
                                     i, s.a[0], s.a[1], MPM_CRACK_NEAR);
    }
    return MPM_OK;
}

static enum mpm_status check_inside_grid(const struct mpm_reading *reading, const char *path,
                                         const struct mpm_crack_spec *crack)
{
    const struct mpm_scene *const scene = reading->scene;
    for (size_t i = 0; i < crack->point_count; i++)
        for (int axis = 0; axis < 2; axis++) {
            const double slack = MPM_CRACK_EDGE_SLACK * scene->cell[axis],
                         place = crack->points[i][axis];
            const bool radius = scene->geometry == MPM_AXISYMMETRIC && axis == 0;
            const double first = scene->origin[axis];
            const double last = first + (double)scene->cells[axis] * scene->cell[axis];
            if (place >= (radius ? fmax(first - slack, 0.0) : first - slack) &&
                place <= last + slack)
                continue;
            return mpm_reading_fault(reading, path,
                                     "point %zu is outside the grid, got %s = %g; allowed: %g to "
                                     "%g",
                                     i, mpm_scene_coordinates(scene)[axis], place,
                                     radius ? fmax(first, 0.0) : first, last);
        }
    return MPM_OK;
}

static bool in_a_body(const struct mpm_scene *scene, const double place[2])
{
    for (size_t i = 0; i < scene->body_count; i++)
        if (!scene->bodies[i].rigid &&
            mpm_region_contains(&scene->bodies[i].region, place, 1e-9 * shorter_side(scene)))
            return true;
    return false;
}

/* Checks its ends and every half cell. */
static bool reaches_a_body(const struct mpm_scene *scene, const struct mpm_segment *segment)
{
    const double count = ceil(distance(segment->a, segment->b) / (0.5 * shorter_side(scene)));
    for (double k = 0.0; k <= count; k += 1.0) {
        const double part = k / count;
        const double place[2] = {segment->a[0] + part * (segment->b[0] - segment->a[0]),
                                 segment->a[1] + part * (segment->b[1] - segment->a[1])};
        if (in_a_body(scene, place))
            return true;
    }
    return false;
}

static enum mpm_status check_in_body(const struct mpm_reading *reading, const char *path,
                                     const struct mpm_crack_spec *crack)
{
    for (size_t i = 0; i + 1 < crack->point_count; i++) {
        const struct mpm_segment segment = segment_of(crack, i);
        if (reaches_a_body(reading->scene, &segment))
            return MPM_OK;
    }
    return mpm_reading_fault(reading, path,
                             "outside every deformable body, from (%g, %g) on; allowed: a crack "
                             "of which some part, checked every half cell, lies in one",
                             crack->points[0][0], crack->points[0][1]);
}

/* -------------------------------------------------- fields of contact that are cut */

/* Inside, and not on its surface, which another body may touch. */
static bool is_within(const struct mpm_scene *scene, size_t body, const double place[2])
{
    static const double around[4][2] = {{-1.0, -1.0}, {1.0, -1.0}, {-1.0, 1.0}, {1.0, 1.0}};
    const double aside = 1e-6 * shorter_side(scene);
    for (int i = 0; i < 4; i++) {
        const double near[2] = {place[0] + aside * around[i][0], place[1] + aside * around[i][1]};
        if (!mpm_region_contains(&scene->bodies[body].region, near, 0.1 * aside))
            return false;
    }
    return true;
}

/* The field of contact that a place is in; MPM_NO_FIELD: none, or it is on a surface. */
static size_t field_at(const struct mpm_scene *scene, const double place[2])
{
    const struct mpm_contact_spec *const contact = &scene->contact;
    for (size_t i = 0; i < scene->body_count; i++)
        if (!scene->bodies[i].rigid && is_within(scene, i, place))
            return contact->field_of[contact->group_of[i]];
    return MPM_NO_FIELD;
}

/* Ends and every half cell of a segment. */
static enum mpm_status check_field(const struct mpm_reading *reading, size_t index, size_t k)
{
    struct mpm_contact_spec *const contact = &reading->scene->contact;
    const struct mpm_segment segment = segment_of(&reading->scene->cracks[index], k);
    const double count =
        ceil(distance(segment.a, segment.b) / (0.5 * shorter_side(reading->scene)));
    for (double i = 0.0; i <= count; i += 1.0) {
        const double part = i / count;
        const double place[2] = {segment.a[0] + part * (segment.b[0] - segment.a[0]),
                                 segment.a[1] + part * (segment.b[1] - segment.a[1])};
        const size_t field = field_at(reading->scene, place);
        if (field != MPM_NO_FIELD && contact->cracked_field == MPM_NO_FIELD)
            contact->cracked_field = field;
        if (field != MPM_NO_FIELD && field != contact->cracked_field)
            return mpm_reading_fault(
                reading, mpm_path_join(mpm_path_entry("cracks", index).text, "points").text,
                "beside contact, cracks in bodies of two velocity fields, the "
                "second one at (%g, %g); allowed: all cracks in bodies of one",
                place[0], place[1]);
    }
    return MPM_OK;
}

enum mpm_status mpm_build_cracked_field(const struct mpm_reading *reading)
{
    struct mpm_scene *const scene = reading->scene;
    scene->contact.cracked_field = MPM_NO_FIELD;
    for (size_t index = 0; index < scene->crack_count; index++)
        for (size_t k = 0; k + 1 < scene->cracks[index].point_count; k++)
            MPM_TRY(check_field(reading, index, k));
    if (scene->crack_count > 0 && scene->contact.cracked_field == MPM_NO_FIELD)
        return mpm_reading_fault(reading, "cracks",
                                 "beside contact, cracks along the surfaces of bodies alone; "
                                 "allowed: cracks with some part, checked every half cell, in one");
    return MPM_OK;
}

/* ---------------------------------------------------------------- meetings */

static enum mpm_status check_itself(const struct mpm_reading *reading, const char *path,
                                    const struct mpm_crack_spec *crack)
{
    const double near = MPM_CRACK_NEAR * shorter_side(reading->scene);
    for (size_t i = 0; i + 1 < crack->point_count; i++)
        for (size_t j = i + 1; j + 1 < crack->point_count; j++) {
            const struct mpm_segment one = segment_of(crack, i), other = segment_of(crack, j);
            if (!(j == i + 1 ? mpm_segments_fold : mpm_segments_meet)(&one, &other, near))
                continue;
            return mpm_reading_fault(reading, path,
                                     "the crack crosses or touches itself, with the segments that "
                                     "start at points %zu and %zu; allowed: an open chain whose "
                                     "segments share only its points",
                                     i, j);
        }
    return MPM_OK;
}

/* With each crack before it. */
static enum mpm_status check_others(const struct mpm_reading *reading, const char *path,
                                    size_t index)
{
    const struct mpm_crack_spec *const cracks = reading->scene->cracks;
    const double near = MPM_CRACK_NEAR * shorter_side(reading->scene);
    for (size_t before = 0; before < index; before++)
        for (size_t i = 0; i + 1 < cracks[before].point_count; i++)
            for (size_t j = 0; j + 1 < cracks[index].point_count; j++) {
                const struct mpm_segment one = segment_of(&cracks[before], i),
                                         other = segment_of(&cracks[index], j);
                if (!mpm_segments_meet(&one, &other, near))
                    continue;
                return mpm_reading_fault(reading, path,
                                         "crosses or touches cracks.%zu, with the segment that "
                                         "starts at point %zu; allowed: cracks that do not meet",
                                         before, j);
            }
    return MPM_OK;
}

/* ------------------------------------------------------------------ cracks */

static enum mpm_status build_points(const struct mpm_reading *reading, const char *path,
                                    const struct mpm_raw_crack *raw, struct mpm_crack_spec *crack)
{
    MPM_TRY(mpm_reading_allocate(reading, raw->points_count, sizeof crack->points[0], "a crack",
                                 &crack->points));
    crack->point_count = raw->points_count;
    for (size_t i = 0; i < crack->point_count; i++)
        for (int axis = 0; axis < 2; axis++)
            crack->points[i][axis] = mpm_raw_double(raw->points[i][axis]);
    MPM_TRY(check_inside_grid(reading, path, crack));
    MPM_TRY(check_lengths(reading, path, crack));
    MPM_TRY(check_itself(reading, path, crack));
    return check_in_body(reading, path, crack);
}

static enum mpm_status check_friction(const struct mpm_reading *reading, const char *path,
                                      const struct mpm_raw_crack *raw)
{
    const bool wanted = raw->contact == MPM_CONTACT_FRICTION;
    if (wanted && raw->friction == NULL)
        return mpm_reading_fault(reading, mpm_path_join(path, "contact").text,
                                 "friction without its coefficient; allowed: friction: a number "
                                 "of at least 0 beside it");
    if (!wanted && raw->friction != NULL)
        return mpm_reading_fault(reading, mpm_path_join(path, "friction").text,
                                 "a coefficient, got %s, without contact: friction; allowed: with "
                                 "it only",
                                 raw->friction);
    return MPM_OK;
}

static enum mpm_status build_crack(const struct mpm_reading *reading, size_t index)
{
    const struct mpm_raw_crack *const raw = &reading->raw->cracks[index];
    struct mpm_crack_spec *const crack = &reading->scene->cracks[index];
    const struct mpm_path path = mpm_path_entry("cracks", index);
    const struct mpm_path points = mpm_path_join(path.text, "points");
    crack->line = mpm_reading_line(reading, path.text);
    crack->contact = (enum mpm_crack_contact)raw->contact;
    crack->detection = (enum mpm_crack_detection)raw->detection;
    crack->friction = mpm_raw_double(raw->friction);
    crack->separated = mpm_raw_double(raw->separated);
    crack->touching = mpm_raw_double(raw->touching);
    crack->spacing = mpm_raw_double(raw->spacing);
    MPM_TRY(check_friction(reading, path.text, raw));
    MPM_TRY(build_points(reading, points.text, raw, crack));
    MPM_TRY(mpm_build_cohesive(reading, path.text, raw, crack));
    MPM_TRY(mpm_build_crack_surface(reading, path.text, raw, crack));
    return check_others(reading, points.text, index);
}

/* Segments are compared pair by pair. */
static enum mpm_status check_point_count(const struct mpm_reading *reading)
{
    size_t count = 0;
    for (unsigned i = 0; i < reading->raw->cracks_count; i++)
        count += reading->raw->cracks[i].points_count;
    if (count <= MPM_POINTS_MAX)
        return MPM_OK;
    return mpm_reading_fault(reading, "cracks",
                             "too many points, got %zu in all cracks; allowed: up to %d", count,
                             MPM_POINTS_MAX);
}

static enum mpm_status check_method(const struct mpm_reading *reading)
{
    const struct mpm_transfer *const transfer = mpm_transfer_of(reading->scene->transfer);
    if (reading->scene->crack_method != MPM_CRACKS_VISIBILITY || transfer->no_visibility == NULL)
        return MPM_OK;
    return mpm_reading_fault(reading, "method.cracks",
                             "visibility is not defined with transfer %s: it %s, and a crack hides "
                             "some; allowed: fields",
                             transfer->name, transfer->no_visibility);
}

enum mpm_status mpm_build_cracks(const struct mpm_reading *reading)
{
    struct mpm_scene *const scene = reading->scene;
    const size_t count = reading->raw->cracks_count;
    scene->crack_method = (enum mpm_crack_method)reading->raw->method->cracks;
    if (count == 0)
        return mpm_reading_given(reading, "method.cracks")
                   ? mpm_reading_fault(reading, "method.cracks",
                                       "given for a scene without cracks; allowed: with cracks: "
                                       "[{points: ...}]")
                   : MPM_OK;
    MPM_TRY(check_method(reading));
    MPM_TRY(check_point_count(reading));
    MPM_TRY(mpm_reading_allocate(reading, count, sizeof *scene->cracks, "cracks", &scene->cracks));
    scene->crack_count = count;
    for (size_t i = 0; i < count; i++)
        MPM_TRY(mpm_reading_note(reading, build_crack(reading, i)));
    return MPM_OK;
}
