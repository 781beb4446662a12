/* What a figure's script may do.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/pages/figure_script.h"

#include <glib.h>
#include <string.h>

enum token_kind {
    TOKEN_WORD,
    TOKEN_NUMBER,
    TOKEN_TEXT,
    TOKEN_BLOCK, /* $name */
    TOKEN_DATA,  /* what a block holds, after its name */
    TOKEN_MARK,  /* one character */
    TOKEN_END,   /* of a line that does not go on, or a semicolon */
};

struct token {
    enum token_kind kind;
    const char *start;
    size_t length;
    unsigned line;
};

struct reader {
    const char *name, *at;
    unsigned line;
    bool generated;
    GArray *tokens; /* struct token */
    struct mpm_error *error;
};

static enum mpm_status refuse(const struct reader *reader, unsigned line, const char *what,
                              size_t length, const char *why)
{
    return failure_set(reader->error, MPM_BAD_INPUT, "%s:%u: %.*s: %s", reader->name, line,
                       (int)MIN(length, 40), what, why);
}

/* --------------------------------------------------------------------- tokens */

static bool is_letter(char c)
{
    return g_ascii_isalpha(c) || c == '_' || (unsigned char)c >= 0x80;
}

static void add(struct reader *reader, enum token_kind kind, size_t length)
{
    const struct token token = {kind, reader->at, length, reader->line};
    g_array_append_val(reader->tokens, token);
    reader->at += length;
}

static size_t word_length(const char *text)
{
    size_t length = 0;
    while (is_letter(text[length]) || g_ascii_isdigit(text[length]))
        length++;
    return length;
}

/* gnuplot's escapes are those of C; the first character is what counts. */
static char first_character(const char *text, char quote)
{
    if (quote != '"' || *text != '\\')
        return *text;
    const gint64 octal = g_ascii_isdigit(text[1]) ? g_ascii_strtoll(text + 1, NULL, 8) : 0;
    return octal != 0 ? (char)octal : text[1];
}

static enum mpm_status read_text(struct reader *reader)
{
    const char quote = *reader->at, *text = reader->at + 1;
    size_t length = 1;
    for (;; length++) {
        const char c = reader->at[length];
        if (c == quote && (quote == '"' || length == 1 || reader->at[length + 1] != quote))
            break; /* of two at the beginning the second ends an empty text */
        if (c == quote)
            length++; /* two are one between single quotes */
        if (c == '\0' || c == '\n')
            return refuse(reader, reader->line, reader->at, length, "a text without an end");
        if (c == '`' && quote == '"')
            return refuse(reader, reader->line, "`", 1, "a figure's script starts no program");
        if (c == '\\' && quote == '"' && reader->at[length + 1] != '\0' &&
            reader->at[length + 1] != '\n')
            length++;
    }
    text += strspn(text, " \t");
    if (!reader->generated && first_character(text, quote) == '<')
        return refuse(reader, reader->line, reader->at, length + 1,
                      "a text that begins with < is a program's output for gnuplot: allowed is "
                      "another beginning");
    add(reader, TOKEN_TEXT, length + 1);
    return MPM_OK;
}

/* $name, and the lines that follow `<< MARK` up to the one that begins with MARK. */
static enum mpm_status read_block(struct reader *reader)
{
    const unsigned line = reader->line;
    const char *start = reader->at;
    add(reader, TOKEN_BLOCK, 1 + MAX(word_length(start + 1), strspn(start + 1, "0123456789")));
    const char *after = reader->at + strspn(reader->at, " \t");
    if (!g_str_has_prefix(after, "<<"))
        return MPM_OK;
    const char *mark = after + 2 + strspn(after + 2, " \t");
    const size_t length = word_length(mark);
    const char *at = strchr(mark, '\n');
    while (length > 0 && at != NULL) {
        reader->line++;
        const char *begin = at + 1 + strspn(at + 1, " \t");
        if (strncmp(begin, mark, length) == 0) {
            add(reader, TOKEN_DATA, (size_t)(begin + length - reader->at));
            return MPM_OK;
        }
        at = strchr(begin, '\n');
    }
    return refuse(reader, line, start, strcspn(start, "\n"), "data without an end");
}

static enum mpm_status read_mark(struct reader *reader)
{
    const char c = *reader->at;
    if (c == '`' || c == '@')
        return refuse(reader, reader->line, reader->at, 1,
                      c == '`' ? "a figure's script starts no program"
                               : "a figure's script has no macros");
    if (c != '\\')
        add(reader, c == ';' ? TOKEN_END : TOKEN_MARK, 1);
    else if (reader->at[1] != '\n')
        return refuse(reader, reader->line, reader->at, 1, "allowed at the end of a line");
    else {
        reader->line++;
        reader->at += 2;
    }
    return MPM_OK;
}

static enum mpm_status read_token(struct reader *reader)
{
    const char c = *reader->at;
    if (c == ' ' || c == '\t' || c == '\r')
        reader->at++;
    else if (c == '#')
        reader->at += strcspn(reader->at, "\n");
    else if (c == '\n') {
        add(reader, TOKEN_END, 1);
        reader->line++;
    } else if (c == '\'' || c == '"')
        return read_text(reader);
    else if (c == '$')
        return read_block(reader);
    else if (is_letter(c))
        add(reader, TOKEN_WORD, word_length(reader->at));
    else if (g_ascii_isdigit(c))
        add(reader, TOKEN_NUMBER, word_length(reader->at));
    else
        return read_mark(reader);
    return MPM_OK;
}

/* ------------------------------------------------------------------- commands */

static const char *const options[] = {
    "arrow",     "autoscale", "bmargin",   "border",    "boxwidth",   "cblabel", "cbrange",
    "cbtics",    "clip",      "cntrlabel", "cntrparam", "colorbox",   "contour", "datafile",
    "dashtype",  "encoding",  "format",    "grid",      "isosamples", "key",     "label",
    "lmargin",   "logscale",  "margins",   "multiplot", "mx2tics",    "mxtics",  "my2tics",
    "mytics",    "object",    "offsets",   "origin",    "output",     "palette", "parametric",
    "pointsize", "polar",     "rmargin",   "rrange",    "samples",    "size",    "style",
    "surface",   "table",     "terminal",  "tics",      "title",      "tmargin", "trange",
    "urange",    "view",      "vrange",    "x2label",   "x2range",    "x2tics",  "xlabel",
    "xrange",    "xtics",     "xzeroaxis", "y2label",   "y2range",    "y2tics",  "ylabel",
    "yrange",    "ytics",     "yzeroaxis", "zlabel",    "zrange",     "ztics",
};

static const struct token *token_at(const struct reader *reader, size_t i)
{
    static const struct token end = {TOKEN_END, "", 0, 0};
    return i < reader->tokens->len ? &g_array_index(reader->tokens, struct token, i) : &end;
}

static bool is(const struct token *token, const char *text)
{
    return token->kind != TOKEN_TEXT && strlen(text) == token->length &&
           strncmp(token->start, text, token->length) == 0;
}

static bool is_end(const struct token *token)
{
    return token->kind == TOKEN_END || is(token, "}");
}

static enum mpm_status refuse_token(const struct reader *reader, const struct token *token,
                                    const char *why)
{
    return refuse(reader, token->line, token->start, token->length, why);
}

/* The place after the bracket that closes the one at `i`. */
static size_t after_bracket(const struct reader *reader, size_t i)
{
    unsigned depth = 0;
    for (; i < reader->tokens->len; i++) {
        const struct token *token = token_at(reader, i);
        if (is(token, "(") || is(token, "["))
            depth++;
        else if ((is(token, ")") || is(token, "]")) && --depth == 0)
            return i + 1;
    }
    return i;
}

/* name = ..., name(...) = ..., name[...] = ... */
static bool is_definition(const struct reader *reader, size_t i)
{
    const struct token *after = token_at(reader, i + 1);
    const size_t equal = is(after, "(") || is(after, "[") ? after_bracket(reader, i + 1) : i + 1;
    return is(token_at(reader, equal), "=") && !is(token_at(reader, equal + 1), "=");
}

static enum mpm_status check_option(const struct reader *reader, size_t i)
{
    const struct token *option = token_at(reader, i + 1), *value = token_at(reader, i + 2);
    bool known = false;
    for (size_t k = 0; k < G_N_ELEMENTS(options); k++)
        known = known || is(option, options[k]);
    if (!known)
        return refuse_token(reader, option, "a figure's script may not set this");
    if (is(token_at(reader, i), "unset"))
        return MPM_OK;
    if (is(option, "output") && !(is(value, "output") && is_end(token_at(reader, i + 3))))
        return refuse_token(reader, option, "allowed is: set output output");
    if (is(option, "terminal") && !is(value, "svg"))
        return refuse_token(reader, option, "allowed is: set terminal svg");
    if (is(option, "table") && value->kind != TOKEN_BLOCK)
        return refuse_token(reader, option, "allowed is: set table $NAME");
    return MPM_OK;
}

static enum mpm_status check_command(const struct reader *reader, size_t i)
{
    static const char *const drawing[] = {"plot", "splot", "stats", "array"};
    const struct token *token = token_at(reader, i), *next = token_at(reader, i + 1);
    if (token->kind == TOKEN_BLOCK && next->kind == TOKEN_DATA)
        return MPM_OK;
    if (token->kind != TOKEN_WORD)
        return refuse_token(reader, token, "no command that a figure's script may have");
    if (is_definition(reader, i))
        return MPM_OK;
    if (is(token, "set") || is(token, "unset"))
        return check_option(reader, i);
    if (is(token, "load")) {
        const bool ours = is(next, "style") || is(next, "axes");
        return ours && is_end(token_at(reader, i + 2))
                   ? MPM_OK
                   : refuse_token(reader, token, "allowed are: load style, load axes");
    }
    for (size_t k = 0; k < G_N_ELEMENTS(drawing); k++)
        if (is(token, drawing[k]))
            return MPM_OK;
    return refuse_token(reader, token, "no command that a figure's script may have");
}

/* Whether a command follows the token at *i, which may be a head: `if (...)`, `do for [...]`,
 * `else`; then *i is its last token. */
static bool passes_head(const struct reader *reader, size_t *i)
{
    const struct token *token = token_at(reader, *i), *next = token_at(reader, *i + 1);
    if (token->kind == TOKEN_END || is(token, "{") || is(token, "}") || is(token, "else"))
        return true;
    if (is(token, "if") && is(next, "(")) {
        *i = after_bracket(reader, *i + 1) - 1;
        return true;
    }
    if (is(token, "do") && is(next, "for") && is(token_at(reader, *i + 2), "[")) {
        *i = after_bracket(reader, *i + 2) - 1;
        return true;
    }
    return false;
}

static enum mpm_status check_tokens(const struct reader *reader)
{
    bool begins = true;
    for (size_t i = 0; i < reader->tokens->len; i++) {
        const struct token *token = token_at(reader, i);
        if (is(token, "system"))
            return refuse_token(reader, token, "a figure's script starts no program");
    }
    for (size_t i = 0; i < reader->tokens->len; i++) {
        const struct token *token = token_at(reader, i);
        if (begins && passes_head(reader, &i))
            continue;
        if (begins)
            TRY(check_command(reader, i));
        begins = token->kind == TOKEN_END || is(token, "{") || is(token, "}");
    }
    return MPM_OK;
}

enum mpm_status figure_script_check(const char *name, const char *text, bool generated,
                                    struct mpm_error *error)
{
    struct reader reader = {
        name, text, 1, generated, g_array_new(FALSE, FALSE, sizeof(struct token)), error};
    enum mpm_status status = MPM_OK;
    while (status == MPM_OK && *reader.at != '\0')
        status = read_token(&reader);
    if (status == MPM_OK)
        status = check_tokens(&reader);
    g_array_unref(reader.tokens);
    return status;
}
