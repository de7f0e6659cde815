/* ---- the global error -----------------------------------------------------------------------
 *
 * A local tolerance says nothing about it: near a saddle it grows out of all proportion.  Squares
 * are summed, as local errors have no common sign. */

#if PLANE && !VARYING
/* Along the motion: the velocity f(x(t)) of an autonomous system solves its variational equation,
 * so a local error made at s has grown by |f(t)| / |f(s)| at t, and has moved a quadrature by
 * f(t) - f(s) in the same proportion.
 * Across it: where two states drive each other and the rest follows, the area between the velocity
 * and an error grows by the exp of the integral of the trace of J (Liouville), so an error across
 * has grown by that over |f(t)| / |f(s)|.
 *
 * At rest for good |f| fades to nothing, and rounding errors over it mean nothing either. */
static const double ACROSS = 0.3;
static const double REST = 1e-9;           /* scales per t_end: slower than that is at rest */

/* Rates at the beginning of a step, and the derivative along the mode. */
static void first_stage(block_t *b)
{
    lanes turn[ND1];
    turns(b->c, b->x, b->method.mode, b->k[0], turn, b->errors.trace);
    cap(b, turn);
}

/* exp(x), within a fifth for |x| < 3 and bounded beyond. */
INLINE double exponential_bound(double x)
{
    const double z = fabs(x), p = 1.0 + z * (1.0 + z * (1.0 / 2 + z * (1.0 / 6 + z / 24)));
    return x < 0.0 ? 1.0 / p : p;
}

static void follow_error(block_t *b, double t_end)
{
    errors_t *e = &b->errors;
    const double rest = REST / t_end;
    LANE_LOOP {
        const double local = b->error[l] <= b->tau[l] ? b->method.local[l] : 0.0;
        const double head = larger(b->method.head[l], rest), tail = b->method.tail[l], per_head = 1.0 / head;
        const double trace = e->trace[l], shift = local * per_head, side = local * head;
        const double grown = exponential_bound(0.5 * e->passed[l] * (e->spread[l] + trace));
        const double area = e->area[l] * grown * grown, across = ACROSS * per_head;
        const double along = local > 0.0 ? (e->drift[l] + shift * shift) * tail * tail : 0.0;
        e->doubt[l] = larger(e->doubt[l], larger(along, area * across * across));
        e->shift[l] = shift * shift;
        e->drift[l] += shift * shift;
        e->area[l] = area + side * side;
        e->passed[l] = b->error[l] <= b->tau[l] ? b->h[l] : 0.0;
        e->spread[l] = trace;
    }
    for (int j = ND; j < NS; ++j)
        LANE_LOOP {
            const double s = e->shift[l], w = b->weight[j][l];
            const double first = b->k[0][j][l], last = b->k[STAGES - 1][j][l];
            const double past = e->past[j][l] + s * first;
            const double past2 = e->past2[j][l] + s * first * first;
            const double moved = last * (e->drift[l] * last - 2.0 * past) + past2;
            e->past[j][l] = past;
            e->past2[j][l] = past2;
            e->doubt[l] = larger(e->doubt[l], s > 0.0 ? moved * w * w : 0.0);
        }
}

/* The estimated global error of a lane that has come to its end. */
static double estimate(const block_t *b, int l, double t_end)
{
    const errors_t *e = &b->errors;
    const double grown = exponential_bound(e->passed[l] * e->spread[l]);
    const double across = ACROSS * grown / larger(b->method.tail[l], REST / t_end);
    return sqrt(larger(e->doubt[l], e->area[l] * across * across));
}

static void forget_error(errors_t *e, int l)
{
    for (int j = 0; j < NS; ++j)
        e->past[j][l] = e->past2[j][l] = 0.0;
    e->drift[l] = e->area[l] = e->passed[l] = e->spread[l] = e->doubt[l] = 0.0;
}

#else
/* An error is carried along by the linearised motion, e' = J e, and each step adds its own in the
 * direction in which its estimate points.  Over a step J is what it is at the beginning; its
 * exponential acts within the plane of e and the fast mode that `cap` follows, where all that
 * grows or dies out quickly is found, and what of J e leaves that plane is added as it is. */
static const double BLAME = 1.0;           /* estimated error / length of e */

/* Rates at the beginning of a step, and the derivatives along the error and the mode. */
static void first_stage(block_t *b)
{
    errors_t *e = &b->errors;
    set_inputs_at(b, 0.0);
    memcpy(e->mode, b->method.mode, sizeof e->mode);
    turns(b->c, INPUTS(b), b->x, e->e, e->mode, b->k[0], e->image, e->turn);
    /* a derivative that does not exist, as of |x| at 0, says nothing */
    for (int j = 0; j < NS; ++j)
        LANE_LOOP e->image[j][l] = e->image[j][l] - e->image[j][l] == 0.0 ? e->image[j][l] : 0.0;
    for (int j = 0; j < ND; ++j)
        LANE_LOOP e->turn[j][l] = e->turn[j][l] - e->turn[j][l] == 0.0 ? e->turn[j][l] : 0.0;
    cap(b, e->turn);
}

/* What the exponential of h times a matrix of two rows makes of (1, 0). */
INLINE void exponential(double a11, double a12, double a21, double a22, double h, double *one,
    double *two)
{
    const double half = 0.5 * h * (a11 + a22), part = 0.5 * h * (a11 - a22);
    const double root = part * part + h * h * a12 * a21, y = smaller(sqrt(fabs(root)), 20.0);
    const double up = lane_exp(y), down = 1.0 / up, flat = y < 1e-3 ? 1.0 : 0.0;
    const double even = root > 0.0 ? 0.5 * (up + down) : lane_cos(y);
    const double odd = root > 0.0 ? 0.5 * (up - down) : lane_sin(y);
    const double per_y = flat > 0.0 ? 1.0 + root / 6.0 : odd / larger(y, 1e-3);
    const double size = lane_exp(larger(smaller(half, 20.0), -40.0));
    *one = size * (even + part * per_y);
    *two = size * h * a21 * per_y;
}

static void follow_error(block_t *b, double t_end)
{
    errors_t *e = &b->errors;
    lanes ee, er, em, mm, rm, et, mt, own, side, drift, scale;
    LANE_LOOP ee[l] = er[l] = em[l] = mm[l] = rm[l] = et[l] = mt[l] = 0.0;
    for (int j = 0; j < ND; ++j)
        LANE_LOOP {
            const double w = b->weight[j][l], error = w * e->e[j][l], image = w * e->image[j][l];
            const double mode = w * e->mode[j][l], turn = w * e->turn[j][l];
            ee[l] += error * error;
            er[l] += error * image;
            em[l] += error * mode;
            mm[l] += mode * mode;
            rm[l] += image * mode;
            et[l] += error * turn;
            mt[l] += mode * turn;
        }
    LANE_LOOP {
        /* with q1 = e / |e| and q2 what of the mode is square to it */
        const double some = ee[l] > 0.0 ? 1.0 : 0.0, per_e = some / (ee[l] + DBL_MIN);
        const double part = em[l] * per_e, left = mm[l] - part * em[l];
        const double good = left > 1e-10 * mm[l] ? 1.0 : 0.0, per_left = good / (left + DBL_MIN);
        const double a11 = er[l] * per_e;
        /* a21 |e| / |q2| and a12 |q2| / |e| */
        const double a21 = (rm[l] - part * er[l]) * per_left;
        const double a12 = good * (et[l] - part * er[l]) * per_e;
        const double a22 = (mt[l] - part * (et[l] + rm[l]) + part * part * er[l]) * per_left;
        const double h = b->error[l] <= b->tau[l] ? b->h[l] : 0.0;
        double one, two;
        exponential(a11, a12, a21, a22, h, &one, &two);
        const double x = larger(smaller(h * a11, 3.0), -30.0);
        const double phi = fabs(x) < 1e-3 ? 1.0 + 0.5 * x : (lane_exp(x) - 1.0) / (fabs(x) < 1e-3 ? 1.0 : x);
        drift[l] = h * phi;
        own[l] = one - two * part - drift[l] * (a11 - a21 * part);
        side[l] = two - drift[l] * a21;
        ee[l] = em[l] = 0.0;
        scale[l] = h > 0.0 ? b->method.local[l] / sqrt(b->method.sharp[l] + DBL_MIN) : 0.0;
    }
    for (int j = 0; j < ND; ++j)
        LANE_LOOP {
            const double w = b->weight[j][l], add = scale[l] > 0.0 ? scale[l] * b->method.e5[j][l] : 0.0;
            const double moved = own[l] * e->e[j][l] + side[l] * e->mode[j][l] + drift[l] * e->image[j][l];
            e->e[j][l] = moved;
            ee[l] += w * moved * w * moved;
            em[l] += w * moved * w * add;
        }
    for (int j = ND; j < NS; ++j)
        LANE_LOOP {
            const double w = b->weight[j][l], add = scale[l] > 0.0 ? scale[l] * b->method.e5[j][l] : 0.0;
            const double moved = e->e[j][l] + drift[l] * e->image[j][l];
            e->e[j][l] = moved;
            ee[l] += w * moved * w * moved;
            em[l] += w * moved * w * add;
        }
    LANE_LOOP {
        /* the sum points where both do, and is as long as two sides of a right angle */
        const double local = scale[l] > 0.0 ? b->method.local[l] : 0.0, sum = ee[l] + local * local;
        e->doubt[l] = larger(e->doubt[l], sum);
        own[l] = sqrt(sum / (sum + 2.0 * fabs(em[l]) + DBL_MIN));
        scale[l] = em[l] < 0.0 ? -scale[l] : scale[l];
    }
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double add = scale[l] != 0.0 ? scale[l] * b->method.e5[j][l] : 0.0;
            e->e[j][l] = own[l] * (e->e[j][l] + add);
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
#endif
