/* Many trajectories side by side, every lane with its own time, step and tolerance.
 *
 * A block holds LANES trajectories as structure of arrays; every loop over lanes is a vector
 * loop.  A lane that has reached the end is written out and loaded with the next trajectory, so
 * no lane waits for a slower neighbour.  A lane never reads another lane: a result does not
 * depend on the number of threads, on the order, or on the company a trajectory keeps.
 *
 * Never build with -ffast-math: it hides NaN and shares rounding errors between lanes.
 */
enum { NODES = 8 };

static const double SAFETY = 0.9, SHRINK = 0.2, GROW = 6.0;

/* @CONSTANTS@ */

typedef struct {
    lanes c[NC], x[NS], begin[NS], f0[NS], scale[NS], weight[NS], xn[NS];
    lanes k[KEPT_STAGES][NS], d[DENSE_TERMS][NS], at[NS], y[NY1];
    lanes largest[WATCHES], first[WATCHES], size[WATCHES];
    lanes t, h, h0, least, tau, error, steps, state, theta, stop, finish;
    method_t method;
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

/* @METHOD@ */

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
        const double wish = next_factor(b, l, ratio);
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
    const double probe = 1e-4 * t_end, ease = 0.5 * pow(tau, 1.0 / ORDER);
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
    begin_method(b, l, tau);
    b->tau[l] = tau;
    b->h[l] = h;
    b->t[l] = 0.0;
    b->state[l] = RUNNING;
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
    restart(b, l, job, finer, b->h0[l] * pow(finer / b->tau[l], 1.0 / ORDER));
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
        attempt(&b, job);
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
