/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/books.h"

#include "verification/measures/fields.h"

#include <math.h>

static double momentum_scale(const struct books *books)
{
    return sqrt(2.0 * books->start.mass * books->start.total_energy);
}

void books_open(struct books *books, const struct mpm_ledger *ledger)
{
    *books = (struct books){
        .start = *ledger, .last = *ledger, .smallest_kinetic = HUGE_VAL, .samples = 0};
    books_add(books, ledger);
}

void books_add(struct books *books, const struct mpm_ledger *ledger)
{
    const struct mpm_ledger *const start = &books->start;
    const double x = ledger->momentum[0] - start->momentum[0];
    const double y = ledger->momentum[1] - start->momentum[1];
    books->last = *ledger;
    books->samples++;
    const double drift = books_energy_now(books);
    books->energy_high = field_larger(books->energy_high, drift);
    books->energy_low = -field_larger(-books->energy_low, -drift);
    books->momentum = field_larger(books->momentum, sqrt(x * x + y * y));
    books->angular_momentum = field_larger(
        books->angular_momentum, fabs(ledger->angular_momentum - start->angular_momentum));
    books->smallest_kinetic =
        -field_larger(-books->smallest_kinetic, -ledger->kinetic_energy / start->total_energy);
}

double books_energy_now(const struct books *books)
{
    const double start = books->start.total_energy - books->start.external_work;
    return (books->last.total_energy - books->last.external_work) / start - 1.0;
}

double books_energy_drift(const struct books *books)
{
    return field_larger(books->energy_high, -books->energy_low);
}

double books_momentum_drift(const struct books *books)
{
    return books->momentum / momentum_scale(books);
}

double books_angular_momentum_drift(const struct books *books, double arm)
{
    return books->angular_momentum / (momentum_scale(books) * arm);
}
