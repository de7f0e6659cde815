/* ---- between the steps ------------------------------------------------------------------- */

/* Whether lane l has made a step. */
INLINE int stepped(const block_t *b, int l) { return b->id[l] >= 0 && b->error[l] <= b->tau[l]; }

/* States and outputs of one lane at the sample times within its step. */
static void sample_lane(const block_t *b, const job_t *job, int l, int64_t begin, int64_t end)
{
    double at[NS][TILE], y[NY1][TILE];
#if VARYING
    double u[NU1][TILE];
#else
    double (*u)[TILE] = NULL;
#endif
    const double per_step = 1.0 / b->h[l];
    for (int64_t from = begin; from < end; from += TILE) {
        const int count = end - from < TILE ? (int)(end - from) : TILE;
        for (int j = 0; j < NS; ++j) {
#pragma omp simd
            for (int s = 0; s < count; ++s)
                at[j][s] = dense(b, j, l, (job->times[from + s] - b->t[l]) * per_step);
        }
        if (job->observed) {
#if VARYING
            inputs_row(&b->in, b->terms, l, job->times + from, u, count);
#endif
            observe_row(b->c, l, u, at, y, count);
        }
        for (int j = 0; j < ROWS; ++j)
            if (job->samples[j])
                memcpy(job->samples[j] + b->id[l] * job->n_times + from, j < NS ? at[j] : y[j - NS],
                       (size_t)count * sizeof(double));
    }
}

/* A step gives the samples before its end, as an input may jump there and what follows counts; the
 * last step gives all that are left. */
static void sample(block_t *b, const job_t *job)
{
    for (int l = 0; l < LANES; ++l) {
        if (!stepped(b, l))
            continue;
        const int cut = b->cause[l] >= 0, last = cut || b->h[l] >= job->t_end - b->t[l];
        const double end = cut ? b->finish[l] : (last ? job->t_end : b->t[l] + b->h[l]);
        const int64_t begin = b->next[l];
        int64_t next = begin;
        while (next < job->n_times && (job->times[next] < end || (last && job->times[next] == end)))
            ++next;
        b->next[l] = next;
        if (next > begin)
            sample_lane(b, job, l, begin, next);
    }
}

/* ---- events ---------------------------------------------------------------------------------
 *
 * Of each watched row the largest value, and the first time at which it is not below its limit,
 * which may end the trajectory.  The two never contradict each other: where a maximum is found that
 * reaches the limit, the time is sought on the way to it, and a maximum that misses the limit by
 * less than the tolerance is said to reach it.
 *
 * Places are fractions of the step, or of what of it the trajectory goes (b->stop). */

/* Values of watch i at a place of each lane's step. */
static void watch_at(block_t *b, const job_t *job, int i, const double *place, double *value)
{
    const int64_t row = job->watches[i].row;
    const double sign = (double)job->watches[i].sign;
    LANE_LOOP b->theta[l] = place[l] * b->stop[l];
    for (int j = 0; j < NS; ++j)
        if (row >= NS || j == row)
            LANE_LOOP b->at[j][l] = dense(b, j, l, b->theta[l]);
    if (row >= NS) {
        set_inputs(b, b->theta);
        observe_lanes(b->c, INPUTS(b), b->at, b->y);
    }
    const double *from = row < NS ? b->at[row] : b->y[row - NS];
    LANE_LOOP value[l] = sign == 0.0 ? fabs(from[l]) : sign * from[l];
}

/* Values of all that is watched at NODES equal parts. */
static void look(block_t *b, const job_t *job, lanes (*node)[NODES + 1])
{
    for (int m = 0; m <= NODES; ++m) {
        LANE_LOOP b->theta[l] = b->stop[l] * ((double)m / NODES);
        for (int j = 0; j < NS; ++j)
            LANE_LOOP b->at[j][l] = dense(b, j, l, b->theta[l]);
        if (job->observed) {
            set_inputs(b, b->theta);
            observe_lanes(b->c, INPUTS(b), b->at, b->y);
        }
        for (int i = 0; i < job->n_watches; ++i) {
            const int64_t row = job->watches[i].row;
            const double *from = row < NS ? b->at[row] : b->y[row - NS];
            const double sign = (double)job->watches[i].sign;
            LANE_LOOP node[i][m][l] = sign == 0.0 ? fabs(from[l]) : sign * from[l];
        }
    }
}

/* Vertex of the parabola through three points at -1, 0, 1, within these; `without` if it has no
 * maximum. */
INLINE double vertex(double left, double middle, double right, double without)
{
    const double bend = left - 2.0 * middle + right, v = 0.5 * (left - right) / bend;
    return bend < 0.0 ? larger(-1.0, smaller(1.0, v)) : without;
}

/* Where the maximum beside node m is by the parabola there, and how high. */
INLINE double summit(const lanes *node, int l, int m, double *top)
{
    const int k = m == 0 ? 1 : (m == NODES ? NODES - 1 : m);
    const double left = node[k - 1][l], middle = node[k][l], right = node[k + 1][l];
    const double v = vertex(left, middle, right, m - k);
    *top = middle + 0.5 * v * (right - left + v * (left - 2.0 * middle + right));
    return (k + v) / NODES;
}

/* The maxima near places, by parabolas of width 1/8, 1/64, 1/512 step. */
static void climb(block_t *b, const job_t *job, int i, double *place, double *top)
{
    lanes at, left, right;
    double width = 1.0 / NODES;
    for (int round = 0; round < 3; ++round) {
        width /= 8.0;
        LANE_LOOP place[l] = larger(smaller(place[l], 1.0 - width), width);
        watch_at(b, job, i, place, top);
        LANE_LOOP at[l] = place[l] - width;
        watch_at(b, job, i, at, left);
        LANE_LOOP at[l] = place[l] + width;
        watch_at(b, job, i, at, right);
        LANE_LOOP place[l] += width * vertex(left[l], top[l], right[l], 0.0);
    }
    watch_at(b, job, i, place, top);
}

/* The largest value of each lane, and its place; sought between the nodes where it may be above
 * those of earlier steps. */
static void find_largest(block_t *b, const job_t *job, int i, const lanes *node, double *place,
    double *top)
{
    lanes there, height, least;
    int climbing[LANES], inside = 0;
    LANE_LOOP top[l] = least[l] = node[0][l], place[l] = 0.0;
    for (int m = 1; m <= NODES; ++m)
        LANE_LOOP {
            const double value = node[m][l];
            place[l] = value > top[l] ? (double)m / NODES : place[l];
            top[l] = larger(value, top[l]);
            least[l] = smaller(value, least[l]);
        }
    for (int l = 0; l < LANES; ++l) {
        there[l] = summit(node, l, (int)(place[l] * NODES), &height[l]);
        climbing[l] = top[l] + 0.05 * (top[l] - least[l]) > b->largest[i][l] && stepped(b, l)
                      && there[l] > 0.0 && there[l] < 1.0;
        inside |= climbing[l];
    }
    if (!inside)
        return;
    climb(b, job, i, there, height);
    for (int l = 0; l < LANES; ++l)
        if (climbing[l] && height[l] > top[l])
            top[l] = height[l], place[l] = there[l];
}

/* Close in on where watch i reaches its limits, between places below them and not below them:
 * inverse quadratic interpolation where it is safe and halves where not (Chandrupatla, Adv. Eng.
 * Software 28, 1997, 145).  The limit is reached at `high`. */
static void find_crossing(block_t *b, const job_t *job, int i, const double *limit, double *low,
    double *high)
{
    lanes x, f, f_low, f_high, share;       /* low and high are on either side, x is the newest */
    watch_at(b, job, i, low, f_low);
    watch_at(b, job, i, high, f_high);
    LANE_LOOP {
        f_low[l] -= limit[l];
        f_high[l] -= limit[l];
        share[l] = 0.5;
    }
    for (int round = 0; round < 60; ++round) {
        double widest = 0.0;
        LANE_LOOP x[l] = low[l] + share[l] * (high[l] - low[l]);
        watch_at(b, job, i, x, f);
#pragma omp simd reduction(max : widest)
        for (int l = 0; l < LANES; ++l) {
            /* a lane that is there already stays, however long the others take */
            const double done = high[l] - low[l] < 1e-12 ? 1.0 : 0.0;
            const double fx = f[l] - limit[l], over = fx >= 0.0 ? 1.0 : 0.0;
            /* newest, other side, and the one that is replaced */
            const double other = over > 0.0 ? low[l] : high[l], f_other = over > 0.0 ? f_low[l] : f_high[l];
            const double old = over > 0.0 ? high[l] : low[l], f_old = over > 0.0 ? f_high[l] : f_low[l];
            const double xi = (x[l] - other) / (old - other), phi = (fx - f_other) / (f_old - f_other);
            const double back = 1.0 - phi, rest = 1.0 - xi;
            const double a = fx / (f_other - fx) * f_old / (f_other - f_old);
            const double c = fx / (f_old - fx) * f_other / (f_old - f_other);
            const double t = a + (old - x[l]) / (other - x[l]) * c;
            const int safe = (phi * phi < xi) & (back * back < rest);
            low[l] = over > done ? low[l] : (done > 0.0 ? low[l] : x[l]);
            f_low[l] = over > done ? f_low[l] : (done > 0.0 ? f_low[l] : fx);
            high[l] = over > done ? x[l] : high[l];
            f_high[l] = over > done ? fx : f_high[l];
            const double width = high[l] - low[l], least = smaller(0.5, 1e-13 / larger(width, 1e-15));
            const double step = safe ? t : 0.5, next = over > 0.0 ? 1.0 - step : step;
            share[l] = larger(least, smaller(1.0 - least, next));
            widest = larger(widest, width);
        }
        if (widest < 1e-12)
            return;
    }
}

/* The earliest node from m on beside which watch i may reach a limit; past the last if none. */
INLINE int candidate(const lanes *node, int l, int m, double limit, double slack)
{
    for (; m <= NODES; ++m) {
        double top;
        summit(node, l, m, &top);
        const int peak = (m == 0 || node[m][l] >= node[m - 1][l]) && (m == NODES || node[m][l] >= node[m + 1][l]);
        if (node[m][l] >= limit || (peak && top + slack >= limit))
            break;
    }
    return m;
}

/* Of watch i in this step: the largest value, and the place where it first is not below its limit,
 * infinite if nowhere. */
static void look_closer(block_t *b, const job_t *job, int i, const lanes *node, double *when,
    double *top)
{
    lanes place, there, height, low, high, limit, slack;
    const watch_t *w = &job->watches[i];
    int from[LANES], open[LANES], pending = 0, crossing = 0;
    find_largest(b, job, i, node, place, top);
    for (int l = 0; l < LANES; ++l) {
        const double far = larger(fabs(top[l]), fabs(node[0][l]));
        limit[l] = b->id[l] >= 0 ? w->limit[b->id[l] * w->limit_stride] : INFINITY;
        b->size[i][l] = far > b->size[i][l] ? far : b->size[i][l];
        slack[l] = job->tol * b->size[i][l];
        when[l] = INFINITY;
        low[l] = high[l] = 0.0;
        const int near = top[l] + 0.02 * b->size[i][l] + slack[l] >= limit[l];
        open[l] = near && stepped(b, l) && b->first[i][l] == INFINITY;
        from[l] = open[l] ? candidate(node, l, 0, limit[l], 0.02 * b->size[i][l]) : NODES + 1;
        pending |= open[l];
    }
    while (pending) {
        int climbing = 0;
        for (int l = 0; l < LANES; ++l) {
            const int peak = open[l] && from[l] <= NODES && node[from[l]][l] < limit[l];
            there[l] = peak ? summit(node, l, from[l], &height[l]) : place[l];
            climbing |= peak;
        }
        if (climbing)
            climb(b, job, i, there, height);
        pending = 0;
        for (int l = 0; l < LANES; ++l) {
            if (!open[l])
                continue;
            const int m = from[l], last = m > NODES, over = !last && node[m][l] >= limit[l];
            const double value = last ? top[l] : (over ? node[m][l] : height[l]);
            const double here = last ? place[l] : (over ? (double)m / NODES : there[l]);
            open[l] = !last && value < limit[l] - slack[l];
            if (open[l]) {
                from[l] = candidate(node, l, m + 1, limit[l], 0.02 * b->size[i][l]);
                pending = 1;
            } else if (value >= limit[l] - slack[l]) {
                top[l] = larger(top[l], larger(value, limit[l]));
                when[l] = low[l] = high[l] = here;
                for (int k = 0; k <= NODES && (double)k / NODES < here; ++k)
                    low[l] = value >= limit[l] && node[k][l] < limit[l] ? (double)k / NODES : low[l];
                crossing |= low[l] < high[l];
            }
        }
    }
    if (!crossing)
        return;
    find_crossing(b, job, i, limit, low, high);
    LANE_LOOP when[l] = when[l] < INFINITY ? high[l] : INFINITY;
}

/* Extremes and events of the step; where one ends the trajectory, b->cause says which, b->finish
 * when, and the new states are those there. */
static void watch(block_t *b, const job_t *job)
{
    lanes node[WATCHES][NODES + 1], when, top;
    int cut = 0;
    LANE_LOOP b->stop[l] = 1.0;
    look(b, job, node);
    lanes stop;
    LANE_LOOP stop[l] = INFINITY;
    for (int i = 0; i < job->n_watches; ++i) {
        if (!job->watches[i].ends)
            continue;
        look_closer(b, job, i, node[i], when, top);
        for (int l = 0; l < LANES; ++l)
            if (when[l] < stop[l]) {
                stop[l] = when[l];
                b->cause[l] = i;
                b->finish[l] = b->t[l] + stop[l] * b->h[l];
                cut = 1;
            }
    }
    if (cut) {
        LANE_LOOP b->stop[l] = smaller(stop[l], 1.0);
        look(b, job, node);
        for (int j = 0; j < NS; ++j)
            LANE_LOOP b->xn[j][l] = stop[l] <= 1.0 ? b->at[j][l] : b->xn[j][l];
    }
    for (int i = 0; i < job->n_watches; ++i) {
        look_closer(b, job, i, node[i], when, top);
        for (int l = 0; l < LANES; ++l) {
            if (!stepped(b, l))
                continue;
            double first = b->t[l] + when[l] * b->stop[l] * b->h[l];
            if (b->cause[l] == i) {
                const watch_t *w = &job->watches[i];
                top[l] = larger(top[l], w->limit[b->id[l] * w->limit_stride]);
                first = b->finish[l];
            }
            b->largest[i][l] = top[l] > b->largest[i][l] ? top[l] : b->largest[i][l];
            b->first[i][l] = smaller(b->first[i][l], first);
        }
    }
}

/* Trajectories that an event has ended are at their end; says whether there are any. */
static int finish(block_t *b)
{
    int ended = 0;
    for (int l = 0; l < LANES; ++l)
        if (b->id[l] >= 0 && b->cause[l] >= 0) {
            b->t[l] = b->finish[l];
            b->state[l] = OK;
            ended = 1;
        }
    return ended;
}
