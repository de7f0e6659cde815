/* A component: the model with its state, inputs and parameters, whatever version of FMI asks.

   Values are asked for by reference, a number: 0 is the time, then come the states, their
   derivatives, the inputs, the parameters and the outputs, each in the order of model.h. */
#include "model.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    NX = MODEL_STATES, NU = MODEL_INPUTS, NP = MODEL_PARAMETERS, NY = MODEL_OUTPUTS,
    X = 1, DX = X + NX, U = DX + NX, P = U + NU, Y = P + NP, END = Y + NY
};

/* What is set from outside. */
typedef struct {
    double time, step, x[NX], u[NU + 1], p[NP + 1];
} values_t;

typedef struct component {
    values_t now;
    double dx[NX], y[NY + 1], tolerance;
    int stale; /* whether derivatives and outputs are those of other values */
    void *environment;
    void (*tell)(struct component *, const char *message);
    char *name;
    void *logger;
} component;

static void reset(component *c)
{
    memset(&c->now, 0, sizeof c->now);
    memcpy(c->now.x, model_x0, sizeof c->now.x);
    memcpy(c->now.u, model_u0, NU * sizeof(double));
    memcpy(c->now.p, model_p0, NP * sizeof(double));
    c->tolerance = 1e-10;
    c->stale = 1;
}

/* A component, or NULL if there is no memory for it. */
static component *created(const char *name, void *environment)
{
    component *c = calloc(1, sizeof *c);
    if (!c || !(c->name = malloc(strlen(name) + 1))) {
        free(c);
        return NULL;
    }
    strcpy(c->name, name);
    c->environment = environment;
    reset(c);
    return c;
}

static void removed(component *c)
{
    if (c)
        free(c->name);
    free(c);
}

/* Say what is wrong; the result is what functions return. */
static int failed(component *c, const char *format, double number)
{
    char message[200];
    snprintf(message, sizeof message, format, number);
    c->tell(c, message);
    return 1;
}

static void refresh(component *c)
{
    if (c->stale) {
        model_rates(c->now.x, c->now.u, c->now.p, c->dx);
        model_outputs(c->now.x, c->now.u, c->now.p, c->y);
        c->stale = 0;
    }
}

/* Read values; 0 if that went well. */
static int get(component *c, const unsigned *references, size_t count, double *values)
{
    refresh(c);
    for (size_t k = 0; k < count; ++k) {
        const unsigned r = references[k];
        if (r >= END)
            return failed(c, "there is no variable with the reference %.0f", r);
        values[k] = r >= Y ? c->y[r - Y] : r >= P ? c->now.p[r - P] : r >= U ? c->now.u[r - U]
            : r >= DX ? c->dx[r - DX] : r >= X ? c->now.x[r - X] : c->now.time;
        if (r >= DX && r < U && !isfinite(values[k]))
            return failed(c, "the derivative with the reference %.0f is no finite number", r);
    }
    return 0;
}

/* Set states, inputs and parameters; 0 if that went well. */
static int set(component *c, const unsigned *references, size_t count, const double *values)
{
    for (size_t k = 0; k < count; ++k) {
        const unsigned r = references[k];
        if (r < X || (r >= DX && r < U) || r >= Y)
            return failed(c, "the variable with the reference %.0f cannot be set", r);
        if (!isfinite(values[k]))
            return failed(c, "the variable with the reference %.0f must be a finite number", r);
        *(r >= P ? &c->now.p[r - P] : r >= U ? &c->now.u[r - U] : &c->now.x[r - X]) = values[k];
    }
    c->stale = 1;
    return 0;
}

/* Read the states or their derivatives, of which the first has a reference. */
static int get_states(component *c, unsigned first, double *values, size_t count)
{
    unsigned references[NX];
    if (count != NX)
        return failed(c, "there are not %.0f states", (double)count);
    for (unsigned k = 0; k < NX; ++k)
        references[k] = first + k;
    return get(c, references, count, values);
}

static int set_states(component *c, const double *x, size_t count)
{
    if (count != NX)
        return failed(c, "there are not %.0f states", (double)count);
    memcpy(c->now.x, x, sizeof c->now.x);
    c->stale = 1;
    return 0;
}

/* Move on by a step. */
static int advance(component *c, double time, double length)
{
    if (!(length > 0))
        return failed(c, "a step must have a length above 0, not %g s", length);
    c->stale = 1;
    if (model_advance(c->now.x, c->now.u, c->now.p, length, c->tolerance, &c->now.step))
        return failed(c, "the motion grows without bound, or too fast, in the step at %g s", time);
    c->now.time = time + length;
    return 0;
}

/* Change of the unknowns as the knowns change. */
static int derive(component *c, const unsigned *unknowns, size_t n_unknowns,
    const unsigned *knowns, size_t n_knowns, const double *seed, double *change)
{
    double d[END] = {0};
    for (size_t k = 0; k < n_knowns; ++k) {
        const unsigned r = knowns[k];
        if (r >= Y || (r >= DX && r < U))
            return failed(c, "nothing can be derived by the variable with the reference %.0f", r);
        d[r] += seed[k];
    }
    model_along(c->now.x, c->now.u, c->now.p, d + X, d + U, d + P, d + DX, d + Y);
    for (size_t k = 0; k < n_unknowns; ++k) {
        if (unknowns[k] >= END)
            return failed(c, "there is no variable with the reference %.0f", unknowns[k]);
        change[k] = d[unknowns[k]];
    }
    return 0;
}
