/* Expressions by muParser, numbers by strtod behind a grammar of our own.
 *
 * muParser is stricter than its host needs in most things, but takes `x=1` as an
 * assignment and `1,2` as a list: both are refused before it sees the text.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm_expression.h"

#include "base/status.h"

#include <locale.h>
#include <math.h>
#include <muParserDLL.h>
#include <stdlib.h>
#include <string.h>

enum { EXPRESSION_LENGTH_MAX = 4096, CACHE_LINE = 64 };

/* muParser copies what it says of a mistake, a part of the text in it, to a buffer of 2048 bytes
 * whatever its length: of texts longer than this it is not asked for it. */
enum { QUOTED_LENGTH_MAX = 1024 };

/* One a worker, a cache line each: workers write their variables all the time. */
struct worker {
    _Alignas(CACHE_LINE) muParserHandle_t parser;
    double place[2];
    double time;
};

struct mpm_expression {
    char *text;
    bool constant;
    bool uniform; /* no coordinate in it */
    double value; /* of a constant */
    int worker_count;
    struct worker *workers; /* NULL for a constant */
};

/* ----------------------------------------------------------------- numbers */

static size_t digits(const char *text)
{
    return strspn(text, "0123456789");
}

/* Length of the longest number at the start of the text, or 0. */
static size_t number_length(const char *text)
{
    const char *c = text;
    c += *c == '+' || *c == '-';
    const size_t whole = digits(c);
    c += whole;
    size_t fraction = 0;
    if (*c == '.') {
        fraction = digits(c + 1);
        c += 1 + fraction;
    }
    if (whole + fraction == 0)
        return 0;
    if (*c == 'e' || *c == 'E') {
        const char *power = c + 1;
        power += *power == '+' || *power == '-';
        if (digits(power) == 0)
            return 0;
        c = power + digits(power);
    }
    return (size_t)(c - text);
}

bool mpm_number_parse(const char *text, double *value)
{
    const size_t length = number_length(text);
    if (length == 0 || text[length] != '\0')
        return false;
    /* strtod takes the decimal point of the thread's locale: make that a point. */
    const locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (plain == (locale_t)0)
        return false;
    const locale_t before = uselocale(plain);
    const double number = strtod(text, NULL);
    (void)uselocale(before);
    freelocale(plain);
    if (!isfinite(number))
        return false;
    *value = number;
    return true;
}

/* ------------------------------------------------------------------ errors */

/* 1-based column of a byte, counted in characters of UTF-8. */
static int column_of(const char *text, size_t byte)
{
    int column = 1;
    for (size_t i = 0; i < byte && text[i] != '\0'; i++)
        column += ((unsigned char)text[i] & 0xc0) != 0x80;
    return column;
}

/* `=` that is no comparison, a comma outside all parentheses, a quote. */
static enum mpm_status refuse_extras(const char *text, struct mpm_error *error)
{
    int depth = 0;
    for (size_t i = 0; text[i] != '\0'; i++) {
        const char c = text[i];
        const char *what = NULL;
        depth += (c == '(') - (c == ')');
        if (c == '=' && text[i + 1] == '=')
            i++;
        else if (c == '=' && (i == 0 || strchr("<>!", text[i - 1]) == NULL))
            what = "an assignment";
        else if (c == ',' && depth <= 0)
            what = "a list of values";
        else if (c == '"')
            what = "a text";
        if (what != NULL)
            return mpm_error_set(error, MPM_BAD_INPUT,
                                 "column %d: '%c' makes %s; allowed: a formula", column_of(text, i),
                                 c, what);
    }
    return MPM_OK;
}

/* Where muParser says that the mistake is, as a byte: of signs like the second one in `--x`
 * it gives the end, of other tokens the start, of some mistakes nothing (-1). */
static size_t mistake_position(muParserHandle_t parser, const char *text)
{
    const size_t length = strlen(text);
    const int said = mupGetErrorPos(parser);
    if (said < 0 || (size_t)said > length)
        return length;
    const size_t position = (size_t)said;
    if (length > QUOTED_LENGTH_MAX)
        return position;
    const char *token = mupGetErrorToken(parser);
    const size_t token_length = strlen(token);
    if (token_length == 0 || token_length > position ||
        strncmp(text + position, token, token_length) == 0)
        return position;
    const size_t start = position - token_length;
    return strncmp(text + start, token, token_length) == 0 ? start : position;
}

/* muParser's message without its own (0-based, sometimes missing) position. */
static enum mpm_status report(muParserHandle_t parser, const char *text, struct mpm_error *error)
{
    enum { UNKNOWN_TOKEN = 1 }; /* muParser's code */
    static const char *const tails[] = {" found at position", " at position", " (position",
                                        " at expression position"};
    static const char *const allowed = "; allowed: numbers, the coordinates, t where time has a "
                                       "meaning, pi, e, operators and functions";
    const bool unknown = mupGetErrorCode(parser) == UNKNOWN_TOKEN;
    const int column = column_of(text, mistake_position(parser, text));
    const char *const said = strlen(text) > QUOTED_LENGTH_MAX ? "a mistake in a long expression"
                                                              : mupGetErrorMsg(parser);
    char what[160];
    strncpy(what, said, sizeof what - 1);
    what[sizeof what - 1] = '\0';
    for (size_t i = 0; i < sizeof tails / sizeof tails[0]; i++) {
        char *tail = strstr(what, tails[i]);
        if (tail != NULL)
            *tail = '\0';
    }
    return mpm_error_set(error, MPM_BAD_INPUT, "column %d: %s%s", column, what,
                         unknown ? allowed : "");
}

static void ignore_error(muParserHandle_t parser)
{
    (void)parser; /* mupError has the error; without a handler muParser might print */
}

/* ---------------------------------------------------------------- creation */

static void define_names(struct worker *worker, const char *const names[2], bool has_time)
{
    mupClearConst(worker->parser);
    mupDefineConst(worker->parser, "pi", acos(-1.0));
    mupDefineConst(worker->parser, "e", exp(1.0));
    mupDefineVar(worker->parser, names[0], &worker->place[0]);
    mupDefineVar(worker->parser, names[1], &worker->place[1]);
    if (has_time)
        mupDefineVar(worker->parser, "t", &worker->time);
}

static enum mpm_status prepare(struct worker *worker, const char *text, const char *const names[2],
                               bool has_time, struct mpm_error *error)
{
    worker->parser = mupCreate(muBASETYPE_FLOAT);
    if (worker->parser == NULL)
        return mpm_error_memory(error, sizeof *worker, "an expression's parser");
    mupSetErrorHandler(worker->parser, ignore_error);
    define_names(worker, names, has_time);
    mupSetExpr(worker->parser, text);
    /* mupError clears the error when it is read: read it once after each call. */
    if (mupError(worker->parser))
        return report(worker->parser, text, error);
    (void)mupEval(worker->parser);
    if (mupError(worker->parser))
        return report(worker->parser, text, error);
    return MPM_OK;
}

/* Workers' parsers; with a single one when the text turns out to be constant. */
static enum mpm_status prepare_all(struct mpm_expression *expression, const char *const names[2],
                                   bool has_time, int workers, struct mpm_error *error)
{
    const size_t bytes = (size_t)workers * sizeof *expression->workers;
    expression->workers = aligned_alloc(CACHE_LINE, bytes);
    if (expression->workers == NULL)
        return mpm_error_memory(error, bytes, "an expression's workers");
    memset(expression->workers, 0, bytes);
    expression->worker_count = workers;
    for (int i = 0; i < workers; i++)
        MPM_TRY(prepare(&expression->workers[i], expression->text, names, has_time, error));
    return MPM_OK;
}

static void release_workers(struct mpm_expression *expression)
{
    for (int i = 0; i < expression->worker_count; i++)
        if (expression->workers[i].parser != NULL)
            mupRelease(expression->workers[i].parser);
    free(expression->workers);
    expression->workers = NULL;
    expression->worker_count = 0;
}

/* muParser gives the variables of the text as the places where it reads them. */
static bool uses_coordinates(const struct worker *worker)
{
    const int count = mupGetExprVarNum(worker->parser);
    for (int i = 0; i < count; i++) {
        const muChar_t *name;
        muFloat_t *variable;
        mupGetExprVar(worker->parser, (unsigned)i, &name, &variable);
        if (variable != &worker->time)
            return true;
    }
    return false;
}

static enum mpm_status parse(struct mpm_expression *expression, const char *const names[2],
                             bool has_time, int workers, struct mpm_error *error)
{
    if (mpm_number_parse(expression->text, &expression->value)) {
        expression->constant = expression->uniform = true;
        return MPM_OK;
    }
    MPM_TRY(refuse_extras(expression->text, error));
    MPM_TRY(prepare_all(expression, names, has_time, workers, error));
    muParserHandle_t first = expression->workers[0].parser;
    expression->uniform = !uses_coordinates(&expression->workers[0]);
    if (mupGetExprVarNum(first) == 0) { /* 2*pi: a constant too */
        expression->constant = true;
        expression->value = mupEval(first);
        release_workers(expression);
    }
    return MPM_OK;
}

enum mpm_status mpm_expression_create(const char *text, const char *const names[2], bool has_time,
                                      int workers, struct mpm_expression **expression,
                                      struct mpm_error *error)
{
    *expression = NULL;
    const size_t length = strlen(text);
    if (length > EXPRESSION_LENGTH_MAX)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "the expression has %zu characters; allowed: up to %d", length,
                             EXPRESSION_LENGTH_MAX);
    struct mpm_expression *made = calloc(1, sizeof *made);
    if (made == NULL)
        return mpm_error_memory(error, sizeof *made, "an expression");
    made->text = strdup(text);
    if (made->text == NULL) {
        free(made);
        return mpm_error_memory(error, length + 1, "an expression");
    }
    const enum mpm_status status = parse(made, names, has_time, workers, error);
    if (status != MPM_OK) {
        mpm_expression_free(made);
        return status;
    }
    *expression = made;
    return MPM_OK;
}

void mpm_expression_free(struct mpm_expression *expression)
{
    if (expression == NULL)
        return;
    release_workers(expression);
    free(expression->text);
    free(expression);
}

/* --------------------------------------------------------------------- use */

double mpm_expression_value(const struct mpm_expression *expression, int worker,
                            const double position[2], double time)
{
    if (expression->constant)
        return expression->value;
    struct worker *own = &expression->workers[worker];
    own->place[0] = position[0];
    own->place[1] = position[1];
    own->time = time;
    return mupEval(own->parser);
}

bool mpm_expression_is_uniform(const struct mpm_expression *expression)
{
    return expression->uniform;
}

const char *mpm_expression_text(const struct mpm_expression *expression)
{
    return expression->text;
}
