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
static const double TRUST = 0.5;           /* estimated global error / tol that is accepted */
static const double REACH = 10.5, HOLD = 0.97;  /* see cap() */
static const double GUARD = 0.7;           /* see measure() */
static const double BETWEEN = 0.003;       /* see measure_between() */

/* What is followed of the global error, see below. */
#if PLANE && !VARYING
typedef struct { lanes drift, past[NS], past2[NS], area, passed, spread, shift, doubt, trace; } errors_t;
#else
typedef struct { lanes e[NS], image[NS], mode[ND1], turn[ND1], doubt; } errors_t;
#endif

typedef struct {
    lanes c[NC], x[NS], begin[NS], f0[NS], scale[NS], weight[NS], xn[NS], e5[NS], e3[NS];
    lanes k[DENSE_STAGES][NS], d[DENSE_TERMS][NS], at[NS], y[NY1];
    lanes largest[WATCHES], first[WATCHES], size[WATCHES];
    lanes mode[ND1], growth, rho, reach, t, h, h0, least, tau, error, local, sharp, head, tail;
    lanes steps, state, theta, stop, finish;
    errors_t errors;
#if VARYING
    inputs_t in;
    lanes u[NU1], when, wish;
    int terms;
#endif
    int64_t id[LANES], next[LANES];
    int retries[LANES], cause[LANES];
} __attribute__((aligned(64))) block_t;

/* Trajectories ready to be loaded into lanes. */
typedef struct {
    lanes p[NP], c[NC], x[NS], xn[NS], k[2][NS], h;
#if VARYING
    inputs_t in;
    lanes u[NU1], when;
#endif
    int64_t id;
    int used, count, filled;               /* filled: numbers that all share are there */
} __attribute__((aligned(64))) queue_t;

#if VARYING
#define INPUTS(b) ((b)->u)
#else
#define INPUTS(b) NULL
#endif

/* Inputs at a fraction of each lane's step. */
INLINE void set_inputs(block_t *b, const double *fraction)
{
#if VARYING
    LANE_LOOP b->when[l] = b->t[l] + fraction[l] * b->h[l];
    inputs_at(&b->in, b->terms, b->when, b->u);
#endif
}

/* Inputs at a fraction that is the same for all. */
INLINE void set_inputs_at(block_t *b, double fraction)
{
#if VARYING
    LANE_LOOP b->when[l] = b->t[l] + fraction * b->h[l];
    inputs_at(&b->in, b->terms, b->when, b->u);
#endif
}

/* ---- step control ------------------------------------------------------------------------ */

/* Keep the step within REACH tau^(1/12) / |largest eigenvalue|.  Near the edge of stability the
 * fast modes that have died out make the error estimate blind, now and then by a factor of a
 * hundred.  The eigenvalue comes from a power iteration that makes one turn a step:
 * turn = J mode. */
static void cap(block_t *b, lanes *turn)
{
    lanes size, grown;
    LANE_LOOP size[l] = grown[l] = 0.0;
    for (int j = 0; j < ND; ++j)
        LANE_LOOP {
            const double w = b->weight[j][l];
            size[l] = larger(size[l], w * fabs(b->mode[j][l]));
            grown[l] = larger(grown[l], w * fabs(turn[j][l]));
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
        LANE_LOOP b->mode[j][l] = size[l] > 0.0 ? turn[j][l] * size[l] : b->mode[j][l];
}

/* Rates at the stage's states in b->at, at c of the step. */
static void stage_rates(block_t *b, int stage, double c)
{
    set_inputs_at(b, c);
    rates(b->c, INPUTS(b), b->at, b->k[stage]);
}

/* @ERRORS@ */

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
        b->sharp[l] = five[l];
    }
    if (between)
        measure_between(b, tol);
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
#if VARYING
        const double goal = smaller(t_end, b->in.until[l]);
#else
        const double goal = t_end;
#endif
        const double ratio = b->error[l] / b->tau[l];
        const double wish = SAFETY * inverse_eighth_root(smaller(ratio, 1e30) + 1e-30);
        const double factor = ratio == ratio ? larger(smaller(wish, GROW), SHRINK) : SHRINK;
        const double past = b->h[l] >= goal - b->t[l] ? goal : b->t[l] + b->h[l];
        const double t = ratio <= 1.0 ? past : b->t[l], rest = goal - t, h = b->h[l] * factor;
        const double steps = b->steps[l] + 1.0;
        const double stuck = ratio == ratio ? (double)STEP_LIMIT : (double)NON_FINITE;
#if VARYING
        /* a step cut short by a break says little about the next one */
        const double size = ratio <= 1.0 && b->h[l] < b->wish[l] ? larger(h, b->wish[l]) : h;
        b->wish[l] = size;
#else
        const double size = h;
#endif
        double state = b->state[l];
        state = steps >= max_steps ? (double)STEP_LIMIT : state;
        state = size < b->least[l] ? stuck : state;
        state = t >= t_end && state < 0.0 ? (double)OK : state;
        b->t[l] = t;
        b->h[l] = h >= rest ? rest : (h + h > rest ? 0.5 * rest : h);
        b->steps[l] = steps;
        b->state[l] = state;
        ended += state >= 0.0 ? 1.0 : 0.0;
    }
    return ended > 0.0;
}

#if VARYING
/* Go on with the next polynomials where they begin. */
static void turn_pages(block_t *b, const job_t *job)
{
    double turned = 0.0;
#pragma omp simd reduction(+ : turned)
    for (int l = 0; l < LANES; ++l)
        turned += b->t[l] >= b->in.until[l] ? 1.0 : 0.0;
    for (int l = 0; turned > 0.0 && l < LANES; ++l) {
        if (!(b->t[l] >= b->in.until[l]) || b->id[l] < 0)
            continue;
        enter(&b->in, l, job, b->id[l], b->t[l]);
        const double rest = smaller(job->t_end, b->in.until[l]) - b->t[l], h = b->wish[l];
        b->h[l] = h >= rest ? rest : (h + h > rest ? 0.5 * rest : h);
    }
}
#endif

/* @BETWEEN@ */

/* ---- loading and unloading ---------------------------------------------------------------- */

static void queue_rates(queue_t *q, int k, double t, lanes *x)
{
#if VARYING
    LANE_LOOP q->when[l] = t;
    inputs_at(&q->in, TERMS, q->when, q->u);
#endif
    rates(q->c, INPUTS(q), x, q->k[k]);
}

/* First steps: an explicit Euler probe measures how fast the velocity changes. */
static void first_steps(queue_t *q, double t_end, double tau)
{
    const double probe = 1e-4 * t_end, ease = 0.5 * pow(tau, 0.125);
    queue_rates(q, 0, 0.0, q->x);
    for (int j = 0; j < NS; ++j)
        LANE_LOOP q->xn[j][l] = q->x[j][l] + probe * q->k[0][j][l];
    queue_rates(q, 1, probe, q->xn);
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
#if VARYING
        enter_first(&q->in, l, job, i);
#endif
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
static void restart(block_t *b, int l, const job_t *job, double tau, double h)
{
    for (int j = 0; j < NS; ++j) {
        b->x[j][l] = b->begin[j][l];
        b->scale[j][l] = larger(fabs(b->begin[j][l]), SCALE_FLOOR);
        b->weight[j][l] = 1.0 / b->scale[j][l];
    }
    for (int i = 0; i < job->n_watches; ++i) {
        b->largest[i][l] = -INFINITY;
        b->first[i][l] = INFINITY;
        b->size[i][l] = 0.0;
    }
    if (b->tau[l] != tau)
        b->reach[l] = REACH * pow(tau, 1.0 / 12.0);
    b->tau[l] = tau;
    b->h[l] = h;
    b->t[l] = 0.0;
    b->state[l] = RUNNING;
    b->growth[l] = b->rho[l] = 0.0;
    for (int j = 0; j < ND; ++j)
        b->mode[j][l] = b->f0[j][l];
    b->next[l] = 0;
    b->cause[l] = -1;
    b->stop[l] = 1.0;
    forget_error(&b->errors, l);
#if VARYING
    enter_first(&b->in, l, job, b->id[l]);
    b->wish[l] = h;
    b->h[l] = smaller(h, b->in.until[l]);
#endif
}

/* Load the queue's next trajectory into lane l, or leave the lane standing still for good. */
static int load(block_t *b, int l, queue_t *q, const job_t *job, int64_t *shared, double tau)
{
    b->id[l] = -1;
    b->state[l] = RUNNING;
    b->h[l] = 0.0;
    b->t[l] = b->least[l] = -1.0;
    b->steps[l] = -INFINITY;
    b->stop[l] = 1.0;
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
    restart(b, l, job, tau, b->h0[l]);
    return 1;
}

static void unload(const block_t *b, int l, const job_t *job)
{
    const int64_t i = b->id[l];
    const int whole = b->state[l] == OK || b->state[l] == UNSURE;
    for (int j = 0; j < NS; ++j)
        if (job->final[j])
            job->final[j][i] = whole ? b->x[j][l] : NAN;
    for (int j = 0; j < job->n_watches; ++j) {
        job->watches[j].largest[i] = b->largest[j][l];
        job->watches[j].first[i] = b->first[j][l];
    }
    for (int j = 0; job->samples && j < ROWS; ++j)
        for (int64_t s = b->next[l]; job->samples[j] && s < job->n_times; ++s)
            job->samples[j][i * job->n_times + s] = NAN;
    job->end[i] = b->t[l];
    job->cause[i] = (int8_t)b->cause[l];
    job->steps[i] = (int32_t)b->steps[l];
    job->estimate[i] = estimate(b, l, job->t_end);
    job->status[i] = (int8_t)b->state[l];
}

/* A lane has come to its end: once more with a finer tolerance if its error may be too large. */
static int retry(block_t *b, int l, const job_t *job)
{
    if (b->state[l] != OK)
        return 0;
    /* at fine tolerances estimates are larger beside the errors, as steps are closer to even */
    const double fine = pow(1e-6 / smaller(job->tol, 1e-6), 0.1), trust = smaller(TRUST * fine, 1.0);
    const double found = estimate(b, l, job->t_end), trusted = trust * job->tol;
    if (found <= trusted)
        return 0;
    if (b->retries[l] == RETRIES || b->tau[l] <= FINEST) {
        b->state[l] = UNSURE;
        return 0;
    }
    const double finer = larger(0.3 * b->tau[l] * trusted / found, FINEST);
    ++b->retries[l];
    restart(b, l, job, finer, b->h0[l] * pow(finer / b->tau[l], 0.125));
    return 1;
}

/* ---- the job ------------------------------------------------------------------------------ */

static void work(const job_t *job, int64_t *shared)
{
    block_t b;
    queue_t q = {.used = 0, .count = 0};
    memset(&b, 0, sizeof b);
#if VARYING
    b.terms = most_terms(job);
#endif
    const int between = job->samples || job->n_watches;
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
            if (job->n_watches)
                watch(&b, job);
            if (job->samples)
                sample(&b, job);
        }
        follow_error(&b, job->t_end);
        int ended = advance(&b, job->t_end, (double)job->max_steps);
        if (job->n_watches)
            ended |= finish(&b);
#if VARYING
        turn_pages(&b, job);
#endif
        if (!ended)
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
