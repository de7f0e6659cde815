/* ---- a step of DOP853 --------------------------------------------------------------------- */

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
            size[l] = larger(size[l], w * fabs(b->method.mode[j][l]));
            grown[l] = larger(grown[l], w * fabs(turn[j][l]));
        }
    LANE_LOOP {
        const double growth = grown[l] / (size[l] + DBL_MIN);
        const double mean = sqrt(growth * b->method.growth[l]);
        const double rho = larger(mean, HOLD * b->method.rho[l]), h = b->h[l];
        b->method.growth[l] = growth;
        b->method.rho[l] = rho;
        b->h[l] = h * rho > b->method.reach[l] ? b->method.reach[l] / rho : h;
        size[l] = growth > 0.0 ? 1.0 / grown[l] : 0.0;
    }
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->method.mode[j][l] = size[l] > 0.0 ? turn[j][l] * size[l] : b->method.mode[j][l];
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
            const double e = BETWEEN * (b->h[l] * b->method.rho[l] + 0.5) * fabs(b->d[6][j][l]) / s;
            b->error[l] = larger(b->error[l], e * b->tau[l] / tol);
        }
}

/* The step's error, and the velocity at its two ends, relative to each state's scale so far.  The
 * error is Hairer's combination of the two estimates of DOP853; the square of the third-order one,
 * which falls with the same power of h, guards against a fifth-order one that is zero by chance. */
static void measure(block_t *b, double tol, int between)
{
    lanes five, three;
    LANE_LOOP five[l] = three[l] = b->method.head[l] = b->method.tail[l] = 0.0;
    for (int j = 0; j < NS; ++j) {
        const double moves = j < ND ? 1.0 : 0.0;
        LANE_LOOP {
            const double w = 1.0 / larger(b->scale[j][l], fabs(b->xn[j][l]));
            const double e5 = b->method.e5[j][l] * w, e3 = b->method.e3[j][l] * w;
            b->weight[j][l] = w;
            five[l] += e5 * e5;
            three[l] += e3 * e3;
            b->method.head[l] = larger(b->method.head[l], moves * w * fabs(b->k[0][j][l]));
            b->method.tail[l] = larger(b->method.tail[l], moves * w * fabs(b->k[STAGES - 1][j][l]));
        }
    }
    LANE_LOOP {
        const double h = b->h[l];
        const double pair = h * five[l] / sqrt(five[l] + 0.01 * three[l] + DBL_MIN);
        b->method.local[l] = b->error[l] = larger(pair, GUARD * h * h * three[l]);
        b->method.sharp[l] = five[l];
    }
    if (between)
        measure_between(b, tol);
}

/* x^(-1/8), within 0.5 %: Newton from a guess by the exponent. */
INLINE double inverse_root(double x)
{
    const double y = from_bits(5182826893670980608 - (bits(x) >> 3)), y2 = y * y, y4 = y2 * y2;
    return y * (1.125 - 0.125 * x * y4 * y4);
}

/* How much longer the next step may be. */
INLINE double next_factor(block_t *b, int l, double ratio)
{
    return SAFETY * inverse_root(smaller(ratio, 1e30) + 1e-30);
}

/* State j of lane l at a fraction of the step. */
INLINE double dense(const block_t *b, int j, int l, double s)
{
    const double r = 1.0 - s;
    const double end = b->d[5][j][l] + s * b->d[6][j][l];
    const double inner = b->d[3][j][l] + s * (b->d[4][j][l] + r * end);
    return b->x[j][l] + s * (b->d[0][j][l] + r * (b->d[1][j][l] + s * (b->d[2][j][l] + r * inner)));
}

/* Put lane l at the beginning of its trajectory. */
static void begin_method(block_t *b, int l, double tau)
{
    if (b->tau[l] != tau)
        b->method.reach[l] = REACH * pow(tau, 1.0 / 12.0);
    b->method.growth[l] = b->method.rho[l] = 0.0;
    for (int j = 0; j < ND; ++j)
        b->method.mode[j][l] = b->f0[j][l];
}
