/* ---- between the steps ------------------------------------------------------------------- */

INLINE double dense(const block_t *b, int j, int l, double s)
{
    const double r = 1.0 - s;
    const double end = b->d[5][j][l] + s * b->d[6][j][l];
    const double inner = b->d[3][j][l] + s * (b->d[4][j][l] + r * end);
    return b->x[j][l] + s * (b->d[0][j][l] + r * (b->d[1][j][l] + s * (b->d[2][j][l] + r * inner)));
}

/* States and outputs of one lane at the sample times within its step. */
static void sample_lane(const block_t *b, const job_t *job, int l, int64_t begin, int64_t end)
{
    double at[NS][TILE], y[NY1][TILE];
    const double per_step = 1.0 / b->h[l];
    for (int64_t from = begin; from < end; from += TILE) {
        const int count = end - from < TILE ? (int)(end - from) : TILE;
        for (int j = 0; j < NS; ++j) {
#pragma omp simd
            for (int s = 0; s < count; ++s)
                at[j][s] = dense(b, j, l, (job->times[from + s] - b->t[l]) * per_step);
        }
        if (job->observed)
            observe_row(b->c, l, at, y, count);
        for (int j = 0; j < ROWS; ++j)
            if (job->samples[j])
                memcpy(job->samples[j] + b->id[l] * job->n_times + from, j < NS ? at[j] : y[j - NS],
                       (size_t)count * sizeof(double));
    }
}

static void sample(block_t *b, const job_t *job)
{
    for (int l = 0; l < LANES; ++l) {
        if (b->id[l] < 0 || !(b->error[l] <= b->tau[l]))
            continue;
        const double end = b->t[l] + b->h[l] >= job->t_end ? job->t_end : b->t[l] + b->h[l];
        const int64_t begin = b->next[l];
        while (b->next[l] < job->n_times && job->times[b->next[l]] <= end)
            ++b->next[l];
        if (b->next[l] > begin)
            sample_lane(b, job, l, begin, b->next[l]);
    }
}

/* All states and outputs at the fraction theta of each lane's step. */
static void observe_at(block_t *b, const job_t *job)
{
    for (int j = 0; j < NS; ++j)
        LANE_LOOP b->at[j][l] = dense(b, j, l, b->theta[l]);
    if (job->observed)
        observe_lanes(b->c, b->at, b->y);
}

/* State or output i as `observe_at` has left it. */
INLINE const double *row(const block_t *b, int i) { return i < NS ? b->at[i] : b->y[i - NS]; }

/* Vertex of the parabola through three points at -1, 0, 1; 0 where there is none. */
INLINE double vertex(double left, double middle, double right)
{
    const double bend = left - 2.0 * middle + right, v = 0.5 * (left - right) / bend;
    return bend < 0.0 ? larger(smaller(v, 1.0), -1.0) : 0.0;
}

/* Whether a step may hold a new largest value, by what the nodes show of it. */
INLINE int rises(const lanes *node, int l, double largest)
{
    double top = 0.0;
    for (int m = 0; m <= NODES; ++m)
        top = larger(top, node[m][l]);
    return top * (1.0 + 1e-2) > largest;
}

/* Close in on the maximum of |row i| near theta: parabolas of width 1/8, 1/64, 1/512 step. */
static void refine_largest(block_t *b, const job_t *job, int i, const lanes *node)
{
    lanes centre, left, right;
    double width = 1.0 / NODES;
    LANE_LOOP {
        double best = node[1][l], place = 1.0, before = node[0][l], after = node[2][l];
        for (int m = 2; m < NODES; ++m) {
            const int up = node[m][l] > best;
            before = up ? node[m - 1][l] : before;
            after = up ? node[m + 1][l] : after;
            place = up ? (double)m : place;
            best = up ? node[m][l] : best;
        }
        centre[l] = (place + vertex(before, best, after)) * width;
    }
    for (int round = 0; round < 3; ++round) {
        width /= 8.0;
        LANE_LOOP {
            centre[l] = larger(smaller(centre[l], 1.0 - width), width);
            b->theta[l] = centre[l] - width;
        }
        observe_at(b, job);
        LANE_LOOP left[l] = fabs(row(b, i)[l]), b->theta[l] = centre[l] + width;
        observe_at(b, job);
        LANE_LOOP right[l] = fabs(row(b, i)[l]), b->theta[l] = centre[l];
        observe_at(b, job);
        LANE_LOOP centre[l] += width * vertex(left[l], fabs(row(b, i)[l]), right[l]);
    }
    LANE_LOOP b->theta[l] = centre[l];
    observe_at(b, job);
    for (int l = 0; l < LANES; ++l) {
        const double top = larger(fabs(row(b, i)[l]), larger(node[0][l], node[NODES][l]));
        if (b->error[l] <= b->tau[l] && rises(node, l, b->largest[i][l]))
            b->largest[i][l] = larger(b->largest[i][l], top);
    }
}

/* First time |row i| reaches its limit within the step: bisection between two nodes. */
static void refine_first(block_t *b, const job_t *job, int i, const lanes *node, double limit)
{
    lanes low, high;
    LANE_LOOP {
        low[l] = high[l] = NODES;
        for (int m = NODES; m >= 0; --m) {
            const int over = node[m][l] >= limit;
            high[l] = over ? m : high[l];
            low[l] = over ? (m ? m - 1.0 : 0.0) : low[l];
        }
        low[l] /= NODES;
        high[l] /= NODES;
    }
    for (int round = 0; round < 40; ++round) {
        LANE_LOOP b->theta[l] = 0.5 * (low[l] + high[l]);
        observe_at(b, job);
        LANE_LOOP {
            const int over = fabs(row(b, i)[l]) >= limit;
            high[l] = over ? b->theta[l] : high[l];
            low[l] = over ? low[l] : b->theta[l];
        }
    }
    LANE_LOOP b->theta[l] = high[l];
}

/* Running extremes of one row over the step. */
static void watch_row(block_t *b, const job_t *job, int i, const lanes *node)
{
    int higher = 0, passed = 0;
    for (int l = 0; l < LANES; ++l) {
        if (b->id[l] < 0 || !(b->error[l] <= b->tau[l]))
            continue;
        double top = 0.0;
        for (int m = 0; m <= NODES; ++m)
            top = larger(top, node[m][l]);
        higher |= rises(node, l, b->largest[i][l]);
        passed |= top >= job->limit[i] && b->first[i][l] == INFINITY;
        if (top > job->range[i])
            b->state[l] = LEFT_RANGE;
    }
    if (higher)
        refine_largest(b, job, i, node);
    if (!passed)
        return;
    refine_first(b, job, i, node, job->limit[i]);
    for (int l = 0; l < LANES; ++l) {
        int over = 0;
        for (int m = 0; m <= NODES; ++m)
            over |= node[m][l] >= job->limit[i];
        if (over && b->error[l] <= b->tau[l])
            b->first[i][l] = smaller(b->first[i][l], b->t[l] + b->theta[l] * b->h[l]);
    }
}

static void watch(block_t *b, const job_t *job)
{
    lanes node[ROWS][NODES + 1];
    for (int m = 0; m <= NODES; ++m) {
        LANE_LOOP b->theta[l] = (double)m / NODES;
        observe_at(b, job);
        for (int i = 0; i < ROWS; ++i)
            if (job->largest[i])
                LANE_LOOP node[i][m][l] = fabs(row(b, i)[l]);
    }
    for (int i = 0; i < ROWS; ++i)
        if (job->largest[i])
            watch_row(b, job, i, node[i]);
}

