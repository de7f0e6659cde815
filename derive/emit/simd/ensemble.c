/* Many trajectories side by side: DOP853, every lane with its own time, step and tolerance.
 *
 * A block holds LANES trajectories as structure of arrays; every loop over lanes is a vector
 * loop.  A lane that has reached the end is written out and loaded with the next trajectory, so
 * no lane waits for a slower neighbour.  A lane never reads another lane: a result does not
 * depend on the number of threads, on the order, or on the company a trajectory keeps.
 *
 * Never build with -ffast-math: it hides NaN and shares rounding errors between lanes.
 */
enum { STAGES = 12, DENSE_STAGES = 16, DENSE_TERMS = 7, NODES = 8 };

static const double SAFETY = 0.9, SHRINK = 0.2, GROW = 6.0;
static const double SHARE = 0.2;           /* local tolerance tau / tol */
static const double TRUST = 1.0;           /* estimated global error / tol that is accepted */
static const double REACH = 10.5, HOLD = 0.97;  /* see cap() */
static const double GUARD = 0.7;           /* see measure() */
static const double ACROSS = 0.3;          /* see follow_error() */
static const double BETWEEN = 0.003;       /* see measure_between() */

typedef struct {
    lanes c[NC], w[NW], x[NS], begin[NS], f0[NS], scale[NS], weight[NS], xn[NS], e5[NS], e3[NS];
    lanes k[DENSE_STAGES][NS], d[DENSE_TERMS][NS], at[NS], y[NY1], largest[ROWS], first[ROWS];
    lanes mode[NS], turn[NS + 1], growth, rho, reach, t, h, h0, least, tau, error, local, head, tail;
    lanes drift, past[NS], past2[NS], area, passed, spread, shift, doubt;
    lanes steps, state, theta;
    int64_t id[LANES], next[LANES];
    int retries[LANES];
} __attribute__((aligned(64))) block_t;

/* Trajectories ready to be loaded into lanes. */
typedef struct {
    lanes p[NP], c[NC], w[NW], x[NS], xn[NS], k[2][NS], h;
    int64_t id;
    int used, count, filled;               /* filled: numbers that all share are there */
} __attribute__((aligned(64))) queue_t;

/* ---- step control ------------------------------------------------------------------------ */

/* Keep the step within REACH tau^(1/12) / |largest eigenvalue|.  Near the edge of stability the
 * fast modes that have died out make the error estimate blind, now and then by a factor of a
 * hundred.  The eigenvalue comes from a power iteration that makes one turn a step:
 * turn = J mode. */
static void cap(block_t *b)
{
    lanes size, grown;
    LANE_LOOP size[l] = grown[l] = 0.0;
    for (int j = 0; j < ND; ++j)
        LANE_LOOP {
            const double w = b->weight[j][l];
            size[l] = larger(size[l], w * fabs(b->mode[j][l]));
            grown[l] = larger(grown[l], w * fabs(b->turn[j][l]));
        }
    LANE_LOOP {
        const double growth = grown[l] / (size[l] + DBL_MIN);
        const double mean = sqrt(growth * b->growth[l]);
        const double rho = larger(mean, HOLD * b->rho[l]), h = b->h[l];
        b->growth[l] = growth;
        b->rho[l] = rho;
        b->h[l] = h * rho > b->reach[l] ? b->reach[l] / rho : h;
        size[l] = growth > 0.0 ? 1.0 / grown[l] : 0.0;
    }
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->mode[j][l] = size[l] > 0.0 ? b->turn[j][l] * size[l] : b->mode[j][l];
}

/* @STAGES@ */

/* The interpolation's error: its last term, made smaller as the next one would be (h |eigenvalue|).
 * It may use up tol, while the error of the step stays below tau. */
static void measure_between(block_t *b, double tol)
{
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double s = larger(b->scale[j][l], fabs(b->xn[j][l]));
            const double e = BETWEEN * (b->h[l] * b->rho[l] + 0.5) * fabs(b->d[6][j][l]) / s;
            b->error[l] = larger(b->error[l], e * b->tau[l] / tol);
        }
}

/* The step's error, and the velocity at its two ends, relative to each state's scale so far.  The
 * error is Hairer's combination of the two estimates of DOP853; the square of the third-order one,
 * which falls with the same power of h, guards against a fifth-order one that is zero by chance. */
static void measure(block_t *b, double tol, int between)
{
    lanes five, three;
    LANE_LOOP five[l] = three[l] = b->head[l] = b->tail[l] = 0.0;
    for (int j = 0; j < NS; ++j) {
        const double moves = j < ND ? 1.0 : 0.0;
        LANE_LOOP {
            const double w = 1.0 / larger(b->scale[j][l], fabs(b->xn[j][l]));
            const double e5 = b->e5[j][l] * w, e3 = b->e3[j][l] * w;
            b->weight[j][l] = w;
            five[l] += e5 * e5;
            three[l] += e3 * e3;
            b->head[l] = larger(b->head[l], moves * w * fabs(b->k[0][j][l]));
            b->tail[l] = larger(b->tail[l], moves * w * fabs(b->k[STAGES - 1][j][l]));
        }
    }
    LANE_LOOP {
        const double h = b->h[l];
        const double pair = h * five[l] / sqrt(five[l] + 0.01 * three[l] + DBL_MIN);
        b->local[l] = b->error[l] = larger(pair, GUARD * h * h * three[l]);
    }
    if (between)
        measure_between(b, tol);
}

/* exp(x), within a fifth for |x| < 3 and bounded beyond. */
INLINE double swell(double x)
{
    const double z = fabs(x), p = 1.0 + z * (1.0 + z * (1.0 / 2 + z * (1.0 / 6 + z / 24)));
    return x < 0.0 ? 1.0 / p : p;
}

/* Follow the global error, which a local tolerance says nothing about: near a saddle it grows out
 * of all proportion.  Squares are summed, as local errors have no common sign.
 *
 * Along the motion: the velocity f(x(t)) of an autonomous system solves its variational equation,
 * so a local error made at s has grown by |f(t)| / |f(s)| at t, and has moved a quadrature by
 * f(t) - f(s) in the same proportion.
 * Across it: with two dynamic states the area between the velocity and an error grows by the exp of
 * the integral of the trace of J (Liouville), so an error across has grown by that over
 * |f(t)| / |f(s)|.
 *
 * At rest for good |f| fades to nothing, and rounding errors over it mean nothing either. */
static void follow_error(block_t *b, double t_end)
{
    const double rest = REST / t_end;
    LANE_LOOP {
        const double e = b->error[l] <= b->tau[l] ? b->local[l] : 0.0;
        const double head = larger(b->head[l], rest), tail = b->tail[l], per_head = 1.0 / head;
        const double trace = b->turn[ND][l], shift = e * per_head, side = e * head;
        const double grown = swell(0.5 * b->passed[l] * (b->spread[l] + trace));
        const double area = b->area[l] * grown * grown, across = ACROSS * per_head;
        const double along = e > 0.0 ? (b->drift[l] + shift * shift) * tail * tail : 0.0;
        b->doubt[l] = larger(b->doubt[l], larger(along, area * across * across));
        b->shift[l] = shift * shift;
        b->drift[l] += shift * shift;
        b->area[l] = area + side * side;
        b->passed[l] = b->error[l] <= b->tau[l] ? b->h[l] : 0.0;
        b->spread[l] = trace;
    }
    for (int j = ND; j < NS; ++j)
        LANE_LOOP {
            const double s = b->shift[l], w = b->weight[j][l];
            const double first = b->k[0][j][l], last = b->k[STAGES - 1][j][l];
            const double past = b->past[j][l] + s * first;
            const double past2 = b->past2[j][l] + s * first * first;
            const double moved = last * (b->drift[l] * last - 2.0 * past) + past2;
            b->past[j][l] = past;
            b->past2[j][l] = past2;
            b->doubt[l] = larger(b->doubt[l], s > 0.0 ? moved * w * w : 0.0);
        }
}

/* The estimated global error of a lane that has come to its end. */
static double estimate(const block_t *b, int l, double t_end)
{
    const double grown = swell(b->passed[l] * b->spread[l]);
    const double across = ACROSS * grown / larger(b->tail[l], REST / t_end);
    return sqrt(larger(b->doubt[l], b->area[l] * across * across));
}

/* x^(-1/8), within 0.5 %: Newton from a guess by the exponent. */
INLINE double inverse_eighth_root(double x)
{
    const double y = from_bits(5182826893670980608 - (bits(x) >> 3)), y2 = y * y, y4 = y2 * y2;
    return y * (1.125 - 0.125 * x * y4 * y4);
}

/* Accept or reject lane by lane and choose the next step; says whether any lane has ended. */
static int advance(block_t *b, double t_end, double max_steps)
{
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double x = b->error[l] <= b->tau[l] ? b->xn[j][l] : b->x[j][l];
            b->x[j][l] = x;
            b->scale[j][l] = larger(b->scale[j][l], fabs(x));
        }
    double ended = 0.0;
#pragma omp simd reduction(+ : ended)
    for (int l = 0; l < LANES; ++l) {
        const double ratio = b->error[l] / b->tau[l];
        const double wish = SAFETY * inverse_eighth_root(smaller(ratio, 1e30) + 1e-30);
        const double factor = ratio == ratio ? larger(smaller(wish, GROW), SHRINK) : SHRINK;
        const double past = b->t[l] + b->h[l] >= t_end ? t_end : b->t[l] + b->h[l];
        const double t = ratio <= 1.0 ? past : b->t[l], rest = t_end - t, h = b->h[l] * factor;
        const double steps = b->steps[l] + 1.0;
        const double stuck = ratio == ratio ? (double)STEP_LIMIT : (double)NON_FINITE;
        double state = b->state[l];
        state = steps >= max_steps ? (double)STEP_LIMIT : state;
        state = h < b->least[l] ? stuck : state;
        state = rest <= 0.0 && state < 0.0 ? (double)OK : state;
        b->t[l] = t;
        b->h[l] = h >= rest ? rest : (h + h > rest ? 0.5 * rest : h);
        b->steps[l] = steps;
        b->state[l] = state;
        ended += state >= 0.0 ? 1.0 : 0.0;
    }
    return ended > 0.0;
}

/* @BETWEEN@ */

/* ---- loading and unloading ---------------------------------------------------------------- */

/* First steps: an explicit Euler probe measures how fast the velocity changes. */
static void first_steps(queue_t *q, double t_end, double tau)
{
    const double probe = 1e-4 * t_end, ease = 0.5 * pow(tau, 0.125);
    rates(q->c, q->w, q->x, q->k[0]);
    for (int j = 0; j < NS; ++j)
        LANE_LOOP q->xn[j][l] = q->x[j][l] + probe * q->k[0][j][l];
    rates(q->c, q->w, q->xn, q->k[1]);
    LANE_LOOP q->h[l] = 0.0;
    for (int j = 0; j < ND; ++j)
        LANE_LOOP {
            const double f = fabs(q->k[0][j][l]), change = fabs(q->k[1][j][l] - q->k[0][j][l]);
            q->h[l] = larger(q->h[l], change / (probe * (f + SCALE_FLOOR)));
        }
    LANE_LOOP q->h[l] = larger(smaller(ease / (q->h[l] + DBL_MIN), t_end), 1e-6 * t_end);
}

/* Take the next trajectories off the job; false if there are none. */
static int fill(queue_t *q, const job_t *job, int64_t *shared, double tau)
{
    int64_t id;
#pragma omp atomic capture
    { id = *shared; *shared += LANES; }
    if (id >= job->n)
        return 0;
    q->id = id;
    q->used = 0;
    q->count = job->n - id < LANES ? (int)(job->n - id) : LANES;
    for (int l = 0; l < LANES; ++l) {
        const int64_t i = l < q->count ? id + l : job->n - 1;
        for (int j = 0; j < NS; ++j)
            q->x[j][l] = job->x0[j][i * job->x0_stride[j]];
    }
    for (int j = 0; j < NP; ++j)
        for (int l = 0; l < LANES && (job->p_stride[j] || !q->filled); ++l) {
            const int64_t i = l < q->count ? id + l : job->n - 1;
            q->p[j][l] = job->p[j][i * job->p_stride[j]];
        }
    q->filled = 1;
    constants(q->p, q->c);
    first_steps(q, job->t_end, tau);
    return 1;
}

/* Put lane l at the beginning of its trajectory. */
static void restart(block_t *b, int l, double tau, double h, int watched)
{
    for (int j = 0; j < NS; ++j) {
        b->x[j][l] = b->begin[j][l];
        b->scale[j][l] = larger(fabs(b->begin[j][l]), SCALE_FLOOR);
        b->weight[j][l] = 1.0 / b->scale[j][l];
        b->past[j][l] = b->past2[j][l] = 0.0;
    }
    for (int i = 0; watched && i < ROWS; ++i)
        b->largest[i][l] = 0.0, b->first[i][l] = INFINITY;
    if (b->tau[l] != tau)
        b->reach[l] = REACH * pow(tau, 1.0 / 12.0);
    b->tau[l] = tau;
    b->h[l] = h;
    b->t[l] = b->drift[l] = b->area[l] = b->passed[l] = b->spread[l] = b->doubt[l] = 0.0;
    b->state[l] = RUNNING;
    b->growth[l] = b->rho[l] = 0.0;
    for (int j = 0; j < ND; ++j)
        b->mode[j][l] = b->f0[j][l];
    b->next[l] = 0;
}

/* Load the queue's next trajectory into lane l, or leave the lane standing still for good. */
static int load(block_t *b, int l, queue_t *q, const job_t *job, int64_t *shared, double tau)
{
    b->id[l] = -1;
    b->state[l] = RUNNING;
    b->h[l] = 0.0;
    b->t[l] = b->least[l] = -1.0;
    b->steps[l] = -INFINITY;
    if (q->used == q->count && !fill(q, job, shared, tau))
        return 0;
    const int from = q->used++;
    for (int j = 0; j < NC; ++j)
        b->c[j][l] = q->c[j][from];
    for (int j = 0; j < NS; ++j)
        b->begin[j][l] = q->x[j][from], b->f0[j][l] = q->k[0][j][from];
    b->id[l] = q->id + from;
    b->h0[l] = q->h[from];
    b->least[l] = SHORTEST * job->t_end;
    b->steps[l] = 0.0;
    b->retries[l] = 0;
    restart(b, l, tau, b->h0[l], job->largest != NULL);
    return 1;
}

static void unload(const block_t *b, int l, const job_t *job)
{
    const int64_t i = b->id[l];
    const int whole = b->state[l] == OK || b->state[l] == UNSURE;
    for (int j = 0; j < NS; ++j)
        if (job->final[j])
            job->final[j][i] = whole ? b->x[j][l] : NAN;
    for (int j = 0; job->largest && j < ROWS; ++j)
        if (job->largest[j]) {
            job->largest[j][i] = b->largest[j][l];
            job->first[j][i] = b->first[j][l];
        }
    for (int j = 0; job->samples && j < ROWS; ++j)
        for (int64_t s = b->next[l]; job->samples[j] && s < job->n_times; ++s)
            job->samples[j][i * job->n_times + s] = NAN;
    job->steps[i] = (int32_t)b->steps[l];
    job->estimate[i] = estimate(b, l, job->t_end);
    job->status[i] = (int8_t)b->state[l];
}

/* A lane has come to its end: once more with a finer tolerance if its error may be too large. */
static int retry(block_t *b, int l, const job_t *job)
{
    if (b->state[l] != OK)
        return 0;
    const double found = estimate(b, l, job->t_end), trusted = TRUST * job->tol;
    if (found <= trusted)
        return 0;
    if (b->retries[l] == RETRIES || b->tau[l] <= FINEST) {
        b->state[l] = UNSURE;
        return 0;
    }
    const double finer = larger(0.3 * b->tau[l] * trusted / found, FINEST);
    ++b->retries[l];
    restart(b, l, finer, b->h0[l] * pow(finer / b->tau[l], 0.125), job->largest != NULL);
    return 1;
}

/* ---- the job ------------------------------------------------------------------------------ */

static void work(const job_t *job, int64_t *shared)
{
    block_t b;
    queue_t q = {.used = 0, .count = 0};
    memset(&b, 0, sizeof b);
    const int between = job->samples || job->largest;
    const double tau = larger(SHARE * job->tol, FINEST);
    int running = 0;
    for (int l = 0; l < LANES; ++l)
        running += load(&b, l, &q, job, shared, tau);
    while (running) {
        attempt(&b);
        if (between)
            prepare_dense(&b);
        measure(&b, job->tol, between);
        if (between) {
            if (job->samples)
                sample(&b, job);
            if (job->largest)
                watch(&b, job);
        }
        follow_error(&b, job->t_end);
        if (!advance(&b, job->t_end, (double)job->max_steps))
            continue;
        for (int l = 0; l < LANES; ++l) {
            if (b.state[l] == RUNNING || b.id[l] < 0 || retry(&b, l, job))
                continue;
            unload(&b, l, job);
            running -= !load(&b, l, &q, job, shared, tau);
        }
    }
}

/* Integrate all trajectories of the job. */
__attribute__((visibility("default"))) void integrate(const job_t *job)
{
    int64_t shared = 0;
    if (job->threads <= 1) {
        work(job, &shared);
        return;
    }
#pragma omp parallel num_threads((int)job->threads)
    work(job, &shared);
}
