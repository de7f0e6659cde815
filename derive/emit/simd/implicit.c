/* ---- a step of Rodas5P -------------------------------------------------------------------- */

/* Rates and Jacobian at the beginning of the step; derivative of the rates by time, which is that
 * of the inputs, by differences. */
static void begin_step(block_t *b, const job_t *job)
{
    method_t *m = &b->method;
    set_inputs_at(b, 0.0);
    jacobian(b->c, INPUTS(b), b->x, b->k[0], m->jacobian);
    /* a derivative that does not exist, as of a length at 0, is none */
    for (int i = 0; i < NS; ++i)
        for (int j = 0; j < ND; ++j)
            LANE_LOOP {
                const double entry = m->jacobian[i][j][l];
                m->jacobian[i][j][l] = entry - entry == 0.0 ? entry : 0.0;
            }
#if VARYING
    if (!job->signals)
        return;
    lanes ahead[NS];
    set_inputs_at(b, DELTA);
    rates(b->c, INPUTS(b), b->x, ahead);
    set_inputs_at(b, -DELTA);
    rates(b->c, INPUTS(b), b->x, m->slope);
    for (int j = 0; j < NS; ++j)
        LANE_LOOP m->slope[j][l] = (ahead[j][l] - m->slope[j][l]) / (2.0 * DELTA);
#endif
}

/* Factors of 1 - h gamma J of the dynamic states, without exchange of rows; reciprocals on the
 * diagonal. */
APART void factorise(block_t *b)
{
    method_t *m = &b->method;
    for (int i = 0; i < ND; ++i)
        for (int j = 0; j < ND; ++j)
            LANE_LOOP m->lu[i][j][l] = (i == j ? 1.0 : 0.0) - GAMMA * b->h[l] * m->jacobian[i][j][l];
    for (int k = 0; k < ND; ++k) {
        LANE_LOOP m->lu[k][k][l] = 1.0 / m->lu[k][k][l];
        for (int i = k + 1; i < ND; ++i) {
            LANE_LOOP m->lu[i][k][l] *= m->lu[k][k][l];
            for (int j = k + 1; j < ND; ++j)
                LANE_LOOP m->lu[i][j][l] -= m->lu[i][k][l] * m->lu[k][j][l];
        }
    }
}

/* Solve (1 - h gamma J) y = r in place; the integrals follow from the dynamic states. */
APART void solve(const block_t *b, lanes *r)
{
    const method_t *m = &b->method;
    for (int i = 1; i < ND; ++i)
        for (int j = 0; j < i; ++j)
            LANE_LOOP r[i][l] -= m->lu[i][j][l] * r[j][l];
    for (int i = ND - 1; i >= 0; --i) {
        for (int j = i + 1; j < ND; ++j)
            LANE_LOOP r[i][l] -= m->lu[i][j][l] * r[j][l];
        LANE_LOOP r[i][l] *= m->lu[i][i][l];
    }
    for (int i = ND; i < NS; ++i) {
        lanes sum;
        LANE_LOOP sum[l] = 0.0;
        for (int j = 0; j < ND; ++j)
            LANE_LOOP sum[l] += m->jacobian[i][j][l] * r[j][l];
        LANE_LOOP r[i][l] += GAMMA * b->h[l] * sum[l];
    }
}

/* Rates at a stage's states in b->at, at c of the step, go to m->right. */
static void stage_rates(block_t *b, double c)
{
    set_inputs_at(b, c);
    rates(b->c, INPUTS(b), b->at, b->method.right);
}

/* @STAGES@ */

/* The step's error relative to each state's scale so far. */
static void measure(block_t *b, double tol, int between)
{
    lanes sum;
    LANE_LOOP sum[l] = 0.0;
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double w = 1.0 / larger(b->scale[j][l], fabs(b->xn[j][l]));
            const double e = b->k[STAGES - 1][j][l] * w;
            b->weight[j][l] = w;
            sum[l] += e * e;
        }
    LANE_LOOP b->method.local[l] = b->error[l] = sqrt(sum[l]);
}

/* ---- the global error -----------------------------------------------------------------------
 *
 * An error is carried along by the linearised motion, whose exponential over a step is that of a
 * rational function with the factors that are there, and each step adds its own in the direction
 * in which its estimate points.  Squares are summed, as local errors have no common sign. */
static const double BLAME = @BLAME@;       /* estimated error / length of e */

static void follow_error(block_t *b, double t_end)
{
    errors_t *e = &b->errors;
    lanes carried[NS], power[NS], length, along, local, turned;
    memcpy(power, e->e, sizeof power);
    for (int k = 0; k < 3; ++k) {
        static const double weight[3] = {@TRANSPORT@};
        solve(b, power);
        for (int j = 0; j < NS; ++j)
            LANE_LOOP carried[j][l] = (k ? carried[j][l] : 0.0) + weight[k] * power[j][l];
    }
    LANE_LOOP length[l] = along[l] = 0.0;
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double went = b->error[l] <= b->tau[l] ? carried[j][l] : e->e[j][l];
            const double own = b->error[l] <= b->tau[l] ? b->k[STAGES - 1][j][l] : 0.0;
            const double w = b->weight[j][l];
            carried[j][l] = went;
            length[l] += w * went * w * went;
            along[l] += w * went * w * own;
        }
    LANE_LOOP {
        /* the sum points where both do, and is as long as two sides of a right angle */
        const double own = b->error[l] <= b->tau[l] ? b->method.local[l] : 0.0;
        const double sum = length[l] + own * own;
        e->doubt[l] = larger(e->doubt[l], sum);
        turned[l] = sqrt(sum / (sum + 2.0 * fabs(along[l]) + DBL_MIN));
        local[l] = own > 0.0 ? (along[l] < 0.0 ? -1.0 : 1.0) : 0.0;
    }
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double own = local[l] != 0.0 ? local[l] * b->k[STAGES - 1][j][l] : 0.0;
            e->e[j][l] = turned[l] * (carried[j][l] + own);
        }
}

/* The estimated global error of a lane that has come to its end. */
static double estimate(const block_t *b, int l, double t_end)
{
    return BLAME * sqrt(b->errors.doubt[l]);
}

static void forget_error(errors_t *e, int l)
{
    for (int j = 0; j < NS; ++j)
        e->e[j][l] = 0.0;
    e->doubt[l] = 0.0;
}

INLINE double inverse_root(double x) { return lane_exp(-0.2 * lane_log(x)); }

/* How much longer the next step may be: as the error says, but not longer than what its change since
 * the last step foretells (Gustafsson), and no longer at all after a failure. */
INLINE double next_factor(block_t *b, int l, double ratio)
{
    method_t *m = &b->method;
    const double e = larger(smaller(ratio, 1e30), 1e-30), h = b->h[l];
    const double wish = SAFETY * inverse_root(e), before = larger(m->e_before[l], 1e-2);
    const double foretold = wish * (h / m->h_before[l]) * inverse_root(larger(e, 1e-2) / before);
    const double most = m->h_before[l] > 0.0 ? smaller(wish, foretold) : smaller(wish, 1.0);
    const int good = ratio <= 1.0;
    m->h_before[l] = good ? h : 0.0;
    m->e_before[l] = e;
    return good ? most : smaller(wish, 0.9);
}

/* State j of lane l at a fraction of the step. */
INLINE double dense(const block_t *b, int j, int l, double s)
{
    const double r = 1.0 - s, bend = b->d[0][j][l] + s * (b->d[1][j][l] + s * b->d[2][j][l]);
    return r * b->x[j][l] + s * (b->xn[j][l] + r * bend);
}

/* Put lane l at the beginning of its trajectory. */
static void begin_method(block_t *b, int l, double tau)
{
    b->method.h_before[l] = DBL_MAX;
    b->method.e_before[l] = 1.0;
}
