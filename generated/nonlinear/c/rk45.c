/* Generated from derive/ (digest 0b025fe68865f259) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
#define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
#define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
#define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
#define CASADI_PREFIX(ID) rk45_ ## ID
#endif
#include <math.h>
#ifndef casadi_real
#define casadi_real double
#endif
#ifndef casadi_int
#define casadi_int long long int
#endif
/* Add prefix to internal symbols */
#define casadi_axpy CASADI_PREFIX(axpy)
#define casadi_c0 CASADI_PREFIX(c0)
#define casadi_c1 CASADI_PREFIX(c1)
#define casadi_c2 CASADI_PREFIX(c2)
#define casadi_c3 CASADI_PREFIX(c3)
#define casadi_c4 CASADI_PREFIX(c4)
#define casadi_c5 CASADI_PREFIX(c5)
#define casadi_clear CASADI_PREFIX(clear)
#define casadi_copy CASADI_PREFIX(copy)
#define casadi_erk CASADI_PREFIX(erk)
#define casadi_erk_backward CASADI_PREFIX(erk_backward)
#define casadi_erk_data CASADI_PREFIX(erk_data)
#define casadi_erk_forward CASADI_PREFIX(erk_forward)
#define casadi_erk_next_t CASADI_PREFIX(erk_next_t)
#define casadi_erk_prob CASADI_PREFIX(erk_prob)
#define casadi_erk_stage_request CASADI_PREFIX(erk_stage_request)
#define casadi_erk_step_start CASADI_PREFIX(erk_step_start)
#define casadi_f0 CASADI_PREFIX(f0)
#define casadi_f1 CASADI_PREFIX(f1)
#define casadi_f10 CASADI_PREFIX(f10)
#define casadi_f11 CASADI_PREFIX(f11)
#define casadi_f12 CASADI_PREFIX(f12)
#define casadi_f13 CASADI_PREFIX(f13)
#define casadi_f14 CASADI_PREFIX(f14)
#define casadi_f15 CASADI_PREFIX(f15)
#define casadi_f16 CASADI_PREFIX(f16)
#define casadi_f17 CASADI_PREFIX(f17)
#define casadi_f18 CASADI_PREFIX(f18)
#define casadi_f19 CASADI_PREFIX(f19)
#define casadi_f2 CASADI_PREFIX(f2)
#define casadi_f20 CASADI_PREFIX(f20)
#define casadi_f3 CASADI_PREFIX(f3)
#define casadi_f4 CASADI_PREFIX(f4)
#define casadi_f5 CASADI_PREFIX(f5)
#define casadi_f6 CASADI_PREFIX(f6)
#define casadi_f7 CASADI_PREFIX(f7)
#define casadi_f8 CASADI_PREFIX(f8)
#define casadi_f9 CASADI_PREFIX(f9)
#define casadi_fabs CASADI_PREFIX(fabs)
#define casadi_fmax CASADI_PREFIX(fmax)
#define casadi_fmin CASADI_PREFIX(fmin)
#define casadi_ivp_accept CASADI_PREFIX(ivp_accept)
#define casadi_ivp_add_vjp CASADI_PREFIX(ivp_add_vjp)
#define casadi_ivp_advance CASADI_PREFIX(ivp_advance)
#define casadi_ivp_back_begin CASADI_PREFIX(ivp_back_begin)
#define casadi_ivp_back_step_begin CASADI_PREFIX(ivp_back_step_begin)
#define casadi_ivp_begin_run CASADI_PREFIX(ivp_begin_run)
#define casadi_ivp_clear_stats CASADI_PREFIX(ivp_clear_stats)
#define casadi_ivp_clear_vjp CASADI_PREFIX(ivp_clear_vjp)
#define casadi_ivp_control CASADI_PREFIX(ivp_control)
#define casadi_ivp_control_t CASADI_PREFIX(ivp_control_t)
#define casadi_ivp_data CASADI_PREFIX(ivp_data)
#define casadi_ivp_dense_weights CASADI_PREFIX(ivp_dense_weights)
#define casadi_ivp_entry_t CASADI_PREFIX(ivp_entry_t)
#define casadi_ivp_error_norm CASADI_PREFIX(ivp_error_norm)
#define casadi_ivp_error_test CASADI_PREFIX(ivp_error_test)
#define casadi_ivp_flag_t CASADI_PREFIX(ivp_flag_t)
#define casadi_ivp_impulse CASADI_PREFIX(ivp_impulse)
#define casadi_ivp_impulse_begin CASADI_PREFIX(ivp_impulse_begin)
#define casadi_ivp_initial_step CASADI_PREFIX(ivp_initial_step)
#define casadi_ivp_interpolate CASADI_PREFIX(ivp_interpolate)
#define casadi_ivp_isfinite CASADI_PREFIX(ivp_isfinite)
#define casadi_ivp_jac_mv CASADI_PREFIX(ivp_jac_mv)
#define casadi_ivp_jac_nz CASADI_PREFIX(ivp_jac_nz)
#define casadi_ivp_jac_t CASADI_PREFIX(ivp_jac_t)
#define casadi_ivp_nnz CASADI_PREFIX(ivp_nnz)
#define casadi_ivp_output CASADI_PREFIX(ivp_output)
#define casadi_ivp_prescribed CASADI_PREFIX(ivp_prescribed)
#define casadi_ivp_prob CASADI_PREFIX(ivp_prob)
#define casadi_ivp_record_t CASADI_PREFIX(ivp_record_t)
#define casadi_ivp_reject CASADI_PREFIX(ivp_reject)
#define casadi_ivp_request CASADI_PREFIX(ivp_request)
#define casadi_ivp_request_control CASADI_PREFIX(ivp_request_control)
#define casadi_ivp_reserve CASADI_PREFIX(ivp_reserve)
#define casadi_ivp_reset CASADI_PREFIX(ivp_reset)
#define casadi_ivp_reset_backward CASADI_PREFIX(ivp_reset_backward)
#define casadi_ivp_retreat CASADI_PREFIX(ivp_retreat)
#define casadi_ivp_seed_stages CASADI_PREFIX(ivp_seed_stages)
#define casadi_ivp_set_work CASADI_PREFIX(ivp_set_work)
#define casadi_ivp_setup CASADI_PREFIX(ivp_setup)
#define casadi_ivp_stage_argument CASADI_PREFIX(ivp_stage_argument)
#define casadi_ivp_step_limit CASADI_PREFIX(ivp_step_limit)
#define casadi_ivp_step_size CASADI_PREFIX(ivp_step_size)
#define casadi_ivp_steps CASADI_PREFIX(ivp_steps)
#define casadi_ivp_stop CASADI_PREFIX(ivp_stop)
#define casadi_ivp_tape_full CASADI_PREFIX(ivp_tape_full)
#define casadi_ivp_tape_pop CASADI_PREFIX(ivp_tape_pop)
#define casadi_ivp_tape_push CASADI_PREFIX(ivp_tape_push)
#define casadi_ivp_task_t CASADI_PREFIX(ivp_task_t)
#define casadi_ivp_work CASADI_PREFIX(ivp_work)
#define casadi_mv CASADI_PREFIX(mv)
#define casadi_mv_dense CASADI_PREFIX(mv_dense)
#define casadi_s0 CASADI_PREFIX(s0)
#define casadi_s1 CASADI_PREFIX(s1)
#define casadi_s2 CASADI_PREFIX(s2)
#define casadi_s3 CASADI_PREFIX(s3)
#define casadi_s4 CASADI_PREFIX(s4)
#define casadi_s5 CASADI_PREFIX(s5)
#define casadi_s6 CASADI_PREFIX(s6)
#define casadi_scal CASADI_PREFIX(scal)
#define casadi_sq CASADI_PREFIX(sq)
#define casadi_zeros CASADI_PREFIX(zeros)
/* Symbol visibility in DLLs */
#ifndef CASADI_SYMBOL_EXPORT
#if defined(_WIN32) || defined(__WIN32__) || defined(__CYGWIN__)
#if defined(STATIC_LINKED)
#define CASADI_SYMBOL_EXPORT
#else
#define CASADI_SYMBOL_EXPORT __declspec(dllexport)
#endif
#elif defined(__GNUC__) && defined(GCC_HASCLASSVISIBILITY)
#define CASADI_SYMBOL_EXPORT __attribute__ ((visibility ("default")))
#else
#define CASADI_SYMBOL_EXPORT
#endif
#endif
casadi_real casadi_sq(casadi_real x) { return x*x;}
void casadi_copy(const casadi_real* x, casadi_int n, casadi_real* y) {
casadi_int i;
if (y) {
if (x) {
for (i=0; i<n; ++i) *y++ = *x++;
} else {
for (i=0; i<n; ++i) *y++ = 0.;
}
}
}
void casadi_axpy(casadi_int n, casadi_real alpha, const casadi_real* x, casadi_real* y) {
casadi_int i;
if (!x || !y) return;
for (i=0; i<n; ++i) *y++ += alpha**x++;
}
void casadi_clear(casadi_real* x, casadi_int n) {
casadi_int i;
if (x) {
for (i=0; i<n; ++i) *x++ = 0;
}
}
void casadi_mv(const casadi_real* x, const casadi_int* sp_x, const casadi_real* y, casadi_real* z, casadi_int tr) {
casadi_int ncol_x, i, el;
const casadi_int *colind_x, *row_x;
if (!x || !y || !z) return;
ncol_x = sp_x[1];
colind_x = sp_x+2; row_x = sp_x + 2 + ncol_x+1;
if (tr) {
for (i=0; i<ncol_x; ++i) {
for (el=colind_x[i]; el<colind_x[i+1]; ++el) {
z[i] += x[el] * y[row_x[el]];
}
}
} else {
for (i=0; i<ncol_x; ++i) {
for (el=colind_x[i]; el<colind_x[i+1]; ++el) {
z[row_x[el]] += x[el] * y[i];
}
}
}
}
void casadi_mv_dense(const casadi_real* x, casadi_int nrow_x, casadi_int ncol_x,
const casadi_real* y, casadi_real* z, casadi_int tr) {
casadi_int i, j;
if (!x || !y || !z) return;
if (tr) {
for (i=0; i<ncol_x; ++i) {
for (j=0; j<nrow_x; ++j) {
z[i] += *x++ * y[j];
}
}
} else {
for (i=0; i<ncol_x; ++i) {
for (j=0; j<nrow_x; ++j) {
z[j] += *x++ * y[i];
}
}
}
}
typedef enum {
IVP_ODE_X, IVP_ALG_X, IVP_QUAD_X,
IVP_ODE_Z, IVP_ALG_Z, IVP_QUAD_Z,
IVP_ODE_T, IVP_ALG_T, IVP_QUAD_T,
IVP_NUM_JAC
} casadi_ivp_jac_t;
typedef enum {
IVP_EVAL_RHS,
IVP_EVAL_JAC,
IVP_EVAL_VJP,
IVP_EVAL_JAC_ADJ,
IVP_EVAL_ZERO,
IVP_EVAL_JUMP,
IVP_EVAL_JUMP_ADJ,
IVP_TAPE_RESERVE,
IVP_STEP_CONTROL,
IVP_EVENT,
IVP_EVENT_ADJ
} casadi_ivp_task_t;
typedef enum {
IVP_CONTROL_SIZE,
IVP_CONTROL_INIT,
IVP_CONTROL_TEST,
IVP_CONTROL_FAIL
} casadi_ivp_control_t;
typedef enum {
IVP_DONE,
IVP_ADVANCE,
IVP_IMPULSE,
IVP_RETREAT,
IVP_NUM_ENTRY
} casadi_ivp_entry_t;
typedef enum {
IVP_SUCCESS,
IVP_MAX_NUM_STEPS,
IVP_STEP_TOO_SMALL,
IVP_INIT_FAILED,
IVP_EVAL_FAILED,
IVP_TAPE_FAILED,
IVP_TOO_MANY_EVENTS,
IVP_EVENT_FAILED
} casadi_ivp_flag_t;
typedef enum {
IVP_RECORD_STEP,
IVP_RECORD_INIT,
IVP_RECORD_EVENT
} casadi_ivp_record_t;
struct casadi_ivp_prob {
casadi_int nx1, nz1, nq1, np1, nu1;
casadi_int nfwd, nadj;
casadi_int n_stages;
const casadi_real *a, *alpha, *m;
casadi_int n_dense;
const casadi_real* m_dense;
const casadi_int* sp_jac[IVP_NUM_JAC];
casadi_int tape_size;
casadi_real step_size;
casadi_int nx_err, nz_err, nq_err;
casadi_real abstol, reltol;
casadi_int order_err;
const casadi_real* m_err;
casadi_real safety, fac_min, fac_max, h_min, h_max, h_init;
casadi_int max_num_steps;
casadi_int ne;
int has_transition;
casadi_real event_tol, event_acceptable_tol;
casadi_int max_event_iter, max_events;
casadi_int nx, nz, nq, nu, nrx, nrz, nrq, nrp, nru, ny, nr;
casadi_int jac_off[IVP_NUM_JAC + 1];
casadi_int nnz_jac;
};
casadi_int casadi_ivp_nnz(const casadi_int* sp) {
return sp ? sp[2 + sp[1]] : 0;
}
void casadi_ivp_setup(struct casadi_ivp_prob* p) {
casadi_int k;
p->nx = p->nx1 * (1 + p->nfwd);
p->nz = p->nz1 * (1 + p->nfwd);
p->nq = p->nq1 * (1 + p->nfwd);
p->nu = p->nu1 * (1 + p->nfwd);
p->nrx = p->nx1 * p->nadj * (1 + p->nfwd);
p->nrz = p->nz1 * p->nadj * (1 + p->nfwd);
p->nrq = p->nq1 * p->nadj * (1 + p->nfwd);
p->nrp = p->np1 * p->nadj * (1 + p->nfwd);
p->nru = p->nu1 * p->nadj * (1 + p->nfwd);
p->ny = p->nx + p->nz + p->nq;
p->nr = p->nrx + p->nrz + p->nrq;
p->jac_off[0] = 0;
for (k = 0; k < IVP_NUM_JAC; ++k) {
p->jac_off[k + 1] = p->jac_off[k] + casadi_ivp_nnz(p->sp_jac[k]);
}
p->nnz_jac = p->jac_off[IVP_NUM_JAC];
}
struct casadi_ivp_data {
const struct casadi_ivp_prob* prob;
struct casadi_ivp_data* active;
struct casadi_ivp_data* nom;
int pause;
casadi_ivp_task_t task;
casadi_ivp_control_t control;
int accepted;
casadi_int next;
casadi_ivp_flag_t status;
int fail;
casadi_real t_arg;
const casadi_real *y_arg, *w;
casadi_real *res;
casadi_real t, t_out, t_stop, t_start;
casadi_real* y;
casadi_real* y_out;
const casadi_real* u;
casadi_real* u_step;
casadi_real t0, h;
casadi_real t1, t_record;
casadi_real* y0;
casadi_int stage;
casadi_real *U, *y_stage, *w_dense;
casadi_real *ry, *rU, *ry0;
casadi_real* seed;
casadi_real t_seed;
casadi_real* ru_step;
casadi_real *jac, *jac_fwd;
casadi_real *jac_adj, *jac_adj_fwd;
casadi_real *vjp_x, *vjp_z, *vjp_p, *vjp_u;
casadi_real *adj_p, *adj_u;
casadi_real* tape;
casadi_int tape_pos, tape_cap, tape_need;
int reset, taping;
casadi_ivp_record_t record;
int record_pending;
casadi_real run_t0, run_t1, run_h;
casadi_int run_n, run_k;
casadi_real h_next, err_prev;
int last_rejected, last_clipped, last_step;
casadi_int n_steps_interval;
casadi_real *e0, *e1, *em, *e_mask, *edot0, *edot1, *edot, *ev_w, *ydot;
int ev_phase, e_valid, jump, ev_restart;
casadi_real ev_ta, ev_tb, ev_tm, t_ev, ev_dt, ev_one;
casadi_int ev_iter, ev_fired, n_events;
casadi_int n_steps, n_reject, n_rhs, n_jac, n_vjp;
};
void casadi_ivp_work(const struct casadi_ivp_prob* p, casadi_int* sz_arg,
casadi_int* sz_res, casadi_int* sz_iw, casadi_int* sz_w) {
*sz_w += p->ny * (p->n_stages + 4) + p->n_stages;
*sz_w += p->nr * (p->n_stages + 3);
*sz_w += p->nu + p->nru;
*sz_w += p->nnz_jac * (1 + p->nfwd) * (1 + p->nadj);
*sz_w += p->nrx + p->nrz + 2 * (p->nrp + p->nru);
*sz_w += p->tape_size;
if (p->ne > 0) *sz_w += 8 * p->ne + p->ny;
}
void casadi_ivp_set_work(struct casadi_ivp_data* d, const casadi_real*** arg, casadi_real*** res,
casadi_int** iw, casadi_real** w) {
const struct casadi_ivp_prob* p = d->prob;
d->y = *w; *w += p->ny;
d->y_out = *w; *w += p->ny;
d->y0 = *w; *w += p->ny;
d->U = *w; *w += p->ny * p->n_stages;
d->y_stage = *w; *w += p->ny;
d->w_dense = *w; *w += p->n_stages;
d->ry = *w; *w += p->nr;
d->rU = *w; *w += p->nr * p->n_stages;
d->ry0 = *w; *w += p->nr;
d->seed = *w; *w += p->nr;
d->u_step = *w; *w += p->nu;
d->ru_step = *w; *w += p->nru;
d->jac = *w; *w += p->nnz_jac;
d->jac_fwd = *w; *w += p->nnz_jac * p->nfwd;
d->jac_adj = *w; *w += p->nnz_jac * p->nadj;
d->jac_adj_fwd = *w; *w += p->nnz_jac * p->nadj * p->nfwd;
d->vjp_x = *w; *w += p->nrx;
d->vjp_z = *w; *w += p->nrz;
d->vjp_p = *w; *w += p->nrp;
d->vjp_u = *w; *w += p->nru;
d->adj_p = *w; *w += p->nrp;
d->adj_u = *w; *w += p->nru;
d->tape = *w; *w += p->tape_size;
if (p->ne > 0) {
d->e0 = *w; *w += p->ne;
d->e1 = *w; *w += p->ne;
d->em = *w; *w += p->ne;
d->e_mask = *w; *w += p->ne;
d->edot0 = *w; *w += p->ne;
d->edot1 = *w; *w += p->ne;
d->edot = *w; *w += p->ne;
d->ev_w = *w; *w += p->ne;
d->ydot = *w; *w += p->ny;
}
d->tape_cap = p->tape_size;
d->tape_pos = 0;
d->next = IVP_DONE;
d->status = IVP_SUCCESS;
d->fail = 0;
d->reset = 0;
d->taping = 0;
d->record_pending = 0;
d->active = d;
d->nom = 0;
d->pause = 0;
d->ev_phase = 0;
d->e_valid = 0;
d->jump = 0;
d->ev_restart = 0;
d->ev_dt = 0;
d->ev_one = 1;
d->ev_fired = -1;
d->n_events = 0;
}
void casadi_ivp_clear_stats(struct casadi_ivp_data* d) {
d->n_steps = d->n_reject = d->n_rhs = d->n_jac = d->n_vjp = 0;
}
void casadi_ivp_reset(struct casadi_ivp_data* d, casadi_real t, const casadi_real* u, int first_call) {
const struct casadi_ivp_prob* p = d->prob;
const struct casadi_ivp_prob* pn;
d->t = t;
d->u = u;
d->reset = 1;
d->e_valid = 0;
if (first_call) {
d->n_events = 0;
d->ev_restart = 0;
d->tape_pos = 0;
casadi_ivp_clear_stats(d);
d->h_next = 0;
d->err_prev = 1;
d->last_rejected = 0;
}
if (d->nom) {
pn = d->nom->prob;
if (first_call) {
casadi_copy(d->y, pn->nx, d->nom->y);
casadi_copy(d->y + p->nx, pn->nz, d->nom->y + pn->nx);
casadi_copy(d->y + p->nx + p->nz, pn->nq, d->nom->y + pn->nx + pn->nz);
}
casadi_ivp_reset(d->nom, t, u, first_call);
}
}
casadi_int casadi_ivp_steps(casadi_real len, casadi_real step_size) {
casadi_int n = (casadi_int) (ceil(len / step_size - 1e-9));
return n < 1 ? 1 : n;
}
void casadi_ivp_begin_run(struct casadi_ivp_data* d) {
const struct casadi_ivp_prob* p = d->prob;
if (p->step_size > 0) {
d->run_t0 = d->t;
d->run_t1 = d->t_stop;
d->run_n = casadi_ivp_steps(d->t_stop - d->t, p->step_size);
d->run_h = (d->run_t1 - d->run_t0) / (casadi_real) (d->run_n);
d->run_k = 0;
}
d->reset = 0;
d->jump = 0;
}
void casadi_ivp_advance(struct casadi_ivp_data* d, casadi_real t_out, casadi_real t_stop, int taping) {
d->t_out = t_out;
d->t_stop = t_stop;
d->taping = taping;
d->status = IVP_SUCCESS;
d->fail = 0;
d->next = IVP_ADVANCE;
d->n_steps_interval = 0;
if (d->nom) {
casadi_ivp_advance(d->nom, t_out, t_stop, 0);
d->nom->pause = 1;
}
}
void casadi_ivp_reset_backward(struct casadi_ivp_data* d) {
const struct casadi_ivp_prob* p = d->prob;
casadi_clear(d->ry, p->nr);
casadi_clear(d->adj_p, p->nrp);
casadi_clear(d->adj_u, p->nru);
casadi_clear(d->jac_adj, p->nnz_jac * p->nadj * (1 + p->nfwd));
d->record_pending = 0;
}
void casadi_ivp_retreat(struct casadi_ivp_data* d, casadi_real t_start, casadi_real t_out) {
d->t = d->t_start = t_start;
d->t_out = t_out;
d->status = IVP_SUCCESS;
d->next = IVP_RETREAT;
}
void casadi_ivp_impulse(struct casadi_ivp_data* d, casadi_real t) {
d->t_seed = t;
d->status = IVP_SUCCESS;
d->next = IVP_IMPULSE;
}
int casadi_ivp_request(struct casadi_ivp_data* d, casadi_ivp_task_t task, casadi_int next) {
d->active = d;
d->task = task;
d->next = next;
d->fail = 0;
return 1;
}
int casadi_ivp_request_control(struct casadi_ivp_data* d, casadi_ivp_control_t control,
casadi_int next) {
d->control = control;
return casadi_ivp_request(d, IVP_STEP_CONTROL, next);
}
int casadi_ivp_stop(struct casadi_ivp_data* d, casadi_ivp_flag_t status) {
d->status = status;
d->next = IVP_DONE;
return 0;
}
casadi_real* casadi_ivp_jac_nz(const struct casadi_ivp_data* d, casadi_real* jac, casadi_int k,
casadi_int ndir, casadi_int dir) {
const casadi_int* off = d->prob->jac_off;
return jac + ndir * off[k] + dir * (off[k + 1] - off[k]);
}
void casadi_ivp_jac_mv(const struct casadi_ivp_data* d, casadi_int k,
casadi_int dir, const casadi_real* v, casadi_real* r, int tr) {
const struct casadi_ivp_prob* p = d->prob;
const casadi_real* nz = dir < 0 ? casadi_ivp_jac_nz(d, d->jac, k, 1, 0)
: casadi_ivp_jac_nz(d, d->jac_fwd, k, p->nfwd, dir);
casadi_mv(nz, p->sp_jac[k], v, r, tr);
}
void casadi_ivp_add_vjp(struct casadi_ivp_data* d, casadi_real* r) {
const struct casadi_ivp_prob* p = d->prob;
if (r) {
casadi_axpy(p->nrx, 1., d->vjp_x, r);
casadi_axpy(p->nrz, 1., d->vjp_z, r + p->nrx);
}
casadi_axpy(p->nrp, 1., d->vjp_p, d->adj_p);
casadi_axpy(p->nru, 1., d->vjp_u, d->adj_u);
}
void casadi_ivp_clear_vjp(struct casadi_ivp_data* d) {
const struct casadi_ivp_prob* p = d->prob;
casadi_clear(d->vjp_x, p->nrx);
casadi_clear(d->vjp_z, p->nrz);
casadi_clear(d->vjp_p, p->nrp);
casadi_clear(d->vjp_u, p->nru);
}
int casadi_ivp_tape_full(struct casadi_ivp_data* d, casadi_ivp_record_t record) {
const struct casadi_ivp_prob* p = d->prob;
casadi_int n = (record == IVP_RECORD_STEP ? p->ny * p->n_stages : 0) + p->ny + p->nu + 5;
if (record == IVP_RECORD_STEP && p->ne > 0) n += p->ny + p->nu + 5;
d->tape_need = d->tape_pos + n;
return n > d->tape_cap - d->tape_pos;
}
int casadi_ivp_reserve(struct casadi_ivp_data* d, casadi_ivp_record_t record, casadi_int next) {
if (!d->taping || !casadi_ivp_tape_full(d, record)) return -1;
if (d->prob->tape_size > 0) return casadi_ivp_stop(d, IVP_TAPE_FAILED);
return casadi_ivp_request(d, IVP_TAPE_RESERVE, next);
}
void casadi_ivp_tape_push(struct casadi_ivp_data* d, const casadi_real* y0, casadi_real h, casadi_real t0, casadi_real t1) {
const struct casadi_ivp_prob* p = d->prob;
casadi_int n_u = d->record == IVP_RECORD_STEP ? p->ny * p->n_stages : 0;
casadi_real* rec = d->tape + d->tape_pos;
casadi_copy(d->U, n_u, rec);
rec += n_u;
casadi_copy(y0, p->ny, rec);
casadi_copy(d->u_step, p->nu, rec + p->ny);
rec += p->ny + p->nu;
rec[0] = h;
rec[1] = t0;
rec[2] = t1;
rec[3] = d->t_out;
rec[4] = d->record;
d->tape_pos += n_u + p->ny + p->nu + 5;
}
int casadi_ivp_tape_pop(struct casadi_ivp_data* d) {
const struct casadi_ivp_prob* p = d->prob;
casadi_int n_u;
casadi_real* rec;
if (d->tape_pos < p->ny + p->nu + 5) return 1;
rec = d->tape + d->tape_pos;
d->record = (casadi_ivp_record_t) ((int) (rec[-1]));
d->t_record = rec[-2];
d->t1 = rec[-3];
d->t0 = rec[-4];
d->h = rec[-5];
n_u = d->record == IVP_RECORD_STEP ? p->ny * p->n_stages : 0;
rec -= p->ny + p->nu + 5;
casadi_copy(rec, p->ny, d->y0);
casadi_copy(rec + p->ny, p->nu, d->u_step);
casadi_copy(rec - n_u, n_u, d->U);
d->tape_pos -= n_u + p->ny + p->nu + 5;
casadi_clear(d->rU, p->nr * p->n_stages);
casadi_clear(d->ry0, p->nr);
casadi_clear(d->ru_step, p->nru);
return 0;
}
void casadi_ivp_stage_argument(struct casadi_ivp_data* d, casadi_int i) {
const struct casadi_ivp_prob* p = d->prob;
casadi_int j;
const casadi_real* a = p->a + i * p->n_stages;
casadi_copy(d->y0, p->ny, d->y_stage);
for (j = 0; j < i; ++j) if (a[j] != 0) casadi_axpy(p->ny, a[j], d->U + j * p->ny, d->y_stage);
}
void casadi_ivp_dense_weights(struct casadi_ivp_data* d, casadi_real theta) {
const struct casadi_ivp_prob* p = d->prob;
casadi_int q;
casadi_real th = theta;
casadi_clear(d->w_dense, p->n_stages);
for (q = 0; q < p->n_dense; ++q) {
casadi_axpy(p->n_stages, th, p->m_dense + q * p->n_stages, d->w_dense);
th *= theta;
}
}
void casadi_ivp_interpolate(struct casadi_ivp_data* d, casadi_real t, casadi_real* y) {
const struct casadi_ivp_prob* p = d->prob;
casadi_ivp_dense_weights(d, (t - d->t0) / d->h);
casadi_copy(d->y0, p->ny, y);
casadi_mv_dense(d->U, p->ny, p->n_stages, d->w_dense, y, 0);
}
void casadi_ivp_seed_stages(struct casadi_ivp_data* d) {
const struct casadi_ivp_prob* p = d->prob;
casadi_int i;
for (i = 0; i < p->n_stages; ++i) {
casadi_axpy(p->nr, d->w_dense[i], d->seed, d->rU + i * p->nr);
}
casadi_axpy(p->nr, 1., d->seed, d->ry0);
}
int casadi_ivp_isfinite(casadi_real x) {
return x - x == 0;
}
int casadi_ivp_step_limit(const struct casadi_ivp_data* d) {
const struct casadi_ivp_prob* p = d->prob;
if (p->step_size > 0 && !d->nom) return d->run_k >= d->run_n;
return d->n_steps_interval >= p->max_num_steps;
}
int casadi_ivp_prescribed(const struct casadi_ivp_data* d) {
return d->prob->step_size > 0 || d->nom != 0;
}
int casadi_ivp_output(struct casadi_ivp_data* d) {
const struct casadi_ivp_prob* p = d->prob;
if (d->t == d->t_out) {
casadi_copy(d->y, p->ny, d->y_out);
return 0;
}
casadi_ivp_interpolate(d, d->t_out, d->y_out);
return 1;
}
void casadi_ivp_accept(struct casadi_ivp_data* d) {
const struct casadi_ivp_prob* p = d->prob;
if (d->nom) {
d->t = d->nom->t;
} else if (p->step_size > 0) {
d->run_k++;
d->t = d->run_k == d->run_n ? d->run_t1 : d->run_t0 + (casadi_real) (d->run_k) * d->run_h;
} else {
d->t = d->last_step ? d->t_stop : d->t0 + d->h;
}
d->last_rejected = 0;
d->n_steps_interval++;
if (d->taping) {
d->record = IVP_RECORD_STEP;
casadi_ivp_tape_push(d, d->y0, d->h, d->t0, d->t);
}
d->n_steps++;
}
int casadi_ivp_back_begin(struct casadi_ivp_data* d) {
casadi_real r;
if (d->status != IVP_SUCCESS) return casadi_ivp_stop(d, d->status);
for (;;) {
if (!d->record_pending && casadi_ivp_tape_pop(d)) return casadi_ivp_stop(d, IVP_SUCCESS);
r = d->record == IVP_RECORD_EVENT ? d->t0 : d->t_record;
if (r > d->t_start) {
d->record_pending = 0;
continue;
}
if (d->record == IVP_RECORD_EVENT ? r <= d->t_out : r < d->t_start) {
d->record_pending = 1;
d->t = d->t_out;
return casadi_ivp_stop(d, IVP_SUCCESS);
}
d->record_pending = 0;
return 1;
}
}
void casadi_ivp_back_step_begin(struct casadi_ivp_data* d) {
const struct casadi_ivp_prob* p = d->prob;
casadi_int i;
for (i = 0; i < p->n_stages; ++i) casadi_axpy(p->nr, p->m[i], d->ry, d->rU + i * p->nr);
casadi_axpy(p->nr, 1., d->ry0, d->ry);
casadi_axpy(p->nru, 1., d->ru_step, d->adj_u);
d->stage = p->n_stages;
}
int casadi_ivp_impulse_begin(struct casadi_ivp_data* d) {
const struct casadi_ivp_prob* p = d->prob;
while (!d->record_pending && !casadi_ivp_tape_pop(d)) {
d->record_pending = (d->record == IVP_RECORD_EVENT ? d->t0 : d->t_record) <= d->t_seed;
}
if (!d->record_pending || d->record != IVP_RECORD_STEP || d->t_seed == d->t1) {
casadi_axpy(p->nr, 1., d->seed, d->ry);
return casadi_ivp_stop(d, IVP_SUCCESS);
}
casadi_ivp_interpolate(d, d->t_seed, d->y_out);
return 1;
}
casadi_real casadi_fmin(casadi_real x, casadi_real y) {
/* Pre-c99 compatibility */
#if __STDC_VERSION__ < 199901L
return x<y ? x : y;
#else
return fmin(x, y);
#endif
}
casadi_real casadi_fmax(casadi_real x, casadi_real y) {
/* Pre-c99 compatibility */
#if __STDC_VERSION__ < 199901L
return x>y ? x : y;
#else
return fmax(x, y);
#endif
}
casadi_real casadi_fabs(casadi_real x) {
/* Pre-c99 compatibility */
#if __STDC_VERSION__ < 199901L
return x>0 ? x : -x;
#else
return fabs(x);
#endif
}
void casadi_ivp_step_size(struct casadi_ivp_data* d) {
const struct casadi_ivp_prob* p = d->prob;
d->last_clipped = 0;
d->last_step = 0;
if (d->h_next <= 0) {
if (p->h_init <= 0) {
d->h = 0;
return;
}
d->h_next = p->h_init;
}
d->h = p->h_max > 0 ? casadi_fmin(d->h_next, p->h_max) : d->h_next;
if (d->t + 1.05 * d->h >= d->t_stop) {
d->last_clipped = d->t + d->h > d->t_stop;
d->h = d->t_stop - d->t;
d->last_step = 1;
} else if (d->t + 2 * d->h > d->t_stop) {
d->h = 0.5 * (d->t_stop - d->t);
}
}
void casadi_ivp_initial_step(struct casadi_ivp_data* d, const casadi_real* f0) {
const struct casadi_ivp_prob* p = d->prob;
casadi_int i;
casadi_real sc, d0 = 0, d1 = 0, h;
for (i = 0; i < p->nx_err; ++i) {
sc = p->abstol + p->reltol * casadi_fabs(d->y[i]);
d0 += (d->y[i] / sc) * (d->y[i] / sc);
d1 += (f0[i] / sc) * (f0[i] / sc);
}
d0 = sqrt(d0 / (casadi_real) (p->nx_err));
d1 = sqrt(d1 / (casadi_real) (p->nx_err));
h = (d0 < 1e-5 || d1 < 1e-5) ? 1e-6 : 0.01 * d0 / d1;
h = casadi_fmin(h, d->t_stop - d->t);
d->h_next = casadi_fmax(h, p->h_min);
}
casadi_real casadi_ivp_error_norm(struct casadi_ivp_data* d) {
const struct casadi_ivp_prob* p = d->prob;
casadi_int k, i, n, offset[3], n_err[3];
casadi_real ri, sum;
casadi_real* e = d->y_stage;
casadi_clear(e, p->ny);
casadi_mv_dense(d->U, p->ny, p->n_stages, p->m_err, e, 0);
offset[0] = 0; offset[1] = p->nx; offset[2] = p->nx + p->nz;
n_err[0] = p->nx_err; n_err[1] = p->nz_err; n_err[2] = p->nq_err;
sum = 0;
n = 0;
for (k = 0; k < 3; ++k) {
for (i = offset[k]; i < offset[k] + n_err[k]; ++i) {
ri = e[i] / (p->abstol + p->reltol * casadi_fmax(casadi_fabs(d->y0[i]), casadi_fabs(d->y[i])));
sum += ri * ri;
n++;
}
}
return n > 0 ? sqrt(sum / (casadi_real) (n)) : 0;
}
void casadi_ivp_reject(struct casadi_ivp_data* d, casadi_real fac) {
const struct casadi_ivp_prob* p = d->prob;
casadi_copy(d->y0, p->ny, d->y);
d->n_reject++;
d->last_rejected = 1;
d->h_next = d->h * fac;
d->accepted = 0;
if (d->h_next < p->h_min) d->status = IVP_STEP_TOO_SMALL;
}
void casadi_ivp_error_test(struct casadi_ivp_data* d) {
const struct casadi_ivp_prob* p = d->prob;
casadi_real err, k, fac;
err = casadi_ivp_error_norm(d);
k = (casadi_real) (p->order_err + 1);
if (!(err <= 1)) {
fac = 0.25;
if (casadi_ivp_isfinite(err)) fac = casadi_fmax(p->fac_min, p->safety * pow(err, -1. / k));
casadi_ivp_reject(d, fac);
return;
}
err = casadi_fmax(err, 1e-10);
fac = p->safety * pow(err, -0.7 / k) * pow(d->err_prev, 0.4 / k);
fac = casadi_fmin(p->fac_max, casadi_fmax(p->fac_min, fac));
if (d->last_rejected) fac = casadi_fmin(fac, 1.);
d->err_prev = casadi_fmax(err, 1e-4);
d->h_next = d->last_clipped ? casadi_fmax(d->h_next, d->h * fac) : d->h * fac;
d->accepted = 1;
}
void casadi_ivp_control(struct casadi_ivp_data* d) {
switch (d->control) {
case IVP_CONTROL_INIT:
casadi_ivp_initial_step(d, d->U);
casadi_ivp_step_size(d);
break;
case IVP_CONTROL_SIZE:
casadi_ivp_step_size(d);
break;
case IVP_CONTROL_TEST:
casadi_ivp_error_test(d);
break;
case IVP_CONTROL_FAIL:
casadi_ivp_reject(d, 0.25);
break;
}
}
void casadi_scal(casadi_int n, casadi_real alpha, casadi_real* x) {
casadi_int i;
if (!x) return;
for (i=0; i<n; ++i) *x++ *= alpha;
}
struct casadi_erk_prob {
int fsal;
};
typedef enum {
ERK_STEP_BEGIN = IVP_NUM_ENTRY,
ERK_STEP_SIZE,
ERK_STEP_INITIAL_SIZE,
ERK_STEP_REPLAY,
ERK_STAGE,
ERK_STEP_CHECK,
ERK_STEP_EVENT,
ERK_BACK_STAGE,
ERK_BACK_SPREAD
} casadi_erk_next_t;
struct casadi_erk_data {
const struct casadi_erk_prob* prob;
struct casadi_erk_data* nom;
casadi_int f_stage;
casadi_real f_scale;
};
int casadi_erk(struct casadi_ivp_data* d, struct casadi_erk_data* e);
int casadi_erk_stage_request(struct casadi_ivp_data* d) {
const struct casadi_ivp_prob* p = d->prob;
casadi_ivp_stage_argument(d, d->stage);
d->t_arg = d->t0 + p->alpha[d->stage] * d->h;
d->y_arg = d->y_stage;
d->res = d->U + d->stage * p->ny;
return casadi_ivp_request(d, IVP_EVAL_RHS, ERK_STAGE);
}
int casadi_erk_step_start(struct casadi_ivp_data* d, struct casadi_erk_data* e) {
const struct casadi_ivp_prob* p = d->prob;
d->t0 = d->t;
casadi_copy(d->y, p->ny, d->y0);
d->stage = 0;
if (e->f_stage >= 0) {
if (e->f_stage > 0) casadi_copy(d->U + e->f_stage * p->ny, p->ny, d->U);
casadi_scal(p->ny, d->h / e->f_scale, d->U);
e->f_stage = -1;
d->stage = 1;
}
return casadi_erk_stage_request(d);
}
int casadi_erk_forward(struct casadi_ivp_data* d, struct casadi_erk_data* e) {
const struct casadi_ivp_prob* p = d->prob;
int ret;
switch (d->next) {
case IVP_ADVANCE:
if (d->reset) {
casadi_ivp_begin_run(d);
e->f_stage = -1;
}
d->next = ERK_STEP_BEGIN;
return casadi_erk_forward(d, e);
case ERK_STEP_BEGIN:
if (d->fail) return casadi_ivp_stop(d, IVP_TAPE_FAILED);
if (d->t >= d->t_out) {
if (!d->pause) casadi_ivp_output(d);
return casadi_ivp_stop(d, IVP_SUCCESS);
}
if (d->jump) {
d->reset = 1;
d->next = IVP_ADVANCE;
return casadi_erk_forward(d, e);
}
if (casadi_ivp_step_limit(d)) return casadi_ivp_stop(d, IVP_MAX_NUM_STEPS);
if ((ret = casadi_ivp_reserve(d, IVP_RECORD_STEP, ERK_STEP_BEGIN)) >= 0) return ret;
casadi_copy(d->u, p->nu, d->u_step);
if (d->nom) {
d->next = ERK_STEP_REPLAY;
return casadi_erk_forward(d, e);
}
if (d->prob->step_size > 0) {
d->h = d->run_h;
return casadi_erk_step_start(d, e);
}
return casadi_ivp_request_control(d, IVP_CONTROL_SIZE, ERK_STEP_SIZE);
case ERK_STEP_SIZE:
if (d->h > 0) return casadi_erk_step_start(d, e);
d->t_arg = d->t;
d->y_arg = d->y;
d->res = d->U;
return casadi_ivp_request(d, IVP_EVAL_RHS, ERK_STEP_INITIAL_SIZE);
case ERK_STEP_INITIAL_SIZE:
if (d->fail) return casadi_ivp_stop(d, IVP_EVAL_FAILED);
d->n_rhs++;
e->f_stage = 0;
e->f_scale = 1;
return casadi_ivp_request_control(d, IVP_CONTROL_INIT, ERK_STEP_SIZE);
case ERK_STEP_REPLAY:
if (casadi_erk(d->nom, e->nom)) {
d->active = d->nom;
return 1;
}
d->active = d;
if (d->nom->status != IVP_SUCCESS) return casadi_ivp_stop(d, d->nom->status);
if (d->nom->next == IVP_DONE) return casadi_ivp_stop(d, IVP_EVAL_FAILED);
d->h = d->nom->h;
return casadi_erk_step_start(d, e);
case ERK_STAGE:
e->f_stage = d->stage > 0 ? 0 : -1;
e->f_scale = d->h;
if (d->fail) {
if (casadi_ivp_prescribed(d)) return casadi_ivp_stop(d, IVP_EVAL_FAILED);
return casadi_ivp_request_control(d, IVP_CONTROL_FAIL, ERK_STEP_CHECK);
}
d->n_rhs++;
casadi_scal(p->ny, d->h, d->U + d->stage * p->ny);
if (++d->stage < p->n_stages) return casadi_erk_stage_request(d);
if (e->prob->fsal) {
casadi_copy(d->y_stage, p->ny, d->y);
} else {
casadi_copy(d->y0, p->ny, d->y);
casadi_mv_dense(d->U, p->ny, p->n_stages, p->m, d->y, 0);
}
if (!casadi_ivp_prescribed(d)) {
return casadi_ivp_request_control(d, IVP_CONTROL_TEST, ERK_STEP_CHECK);
}
d->accepted = 1;
d->next = ERK_STEP_CHECK;
return casadi_erk_forward(d, e);
case ERK_STEP_CHECK:
if (d->status != IVP_SUCCESS) return casadi_ivp_stop(d, d->status);
if (!d->accepted) {
d->next = ERK_STEP_BEGIN;
return casadi_erk_forward(d, e);
}
e->f_stage = e->prob->fsal ? p->n_stages - 1 : -1;
casadi_ivp_accept(d);
if (p->ne > 0) return casadi_ivp_request(d, IVP_EVENT, ERK_STEP_EVENT);
d->next = ERK_STEP_EVENT;
return casadi_erk_forward(d, e);
case ERK_STEP_EVENT:
if (d->status != IVP_SUCCESS) return casadi_ivp_stop(d, d->status);
d->next = ERK_STEP_BEGIN;
if (d->pause) {
d->status = IVP_SUCCESS;
return 0;
}
return casadi_erk_forward(d, e);
default:
return 0;
}
}
int casadi_erk_backward(struct casadi_ivp_data* d, struct casadi_erk_data* e) {
const struct casadi_ivp_prob* p = d->prob;
casadi_int i, j, s = p->n_stages;
casadi_real* rUi;
switch (d->next) {
case IVP_RETREAT:
if (!casadi_ivp_back_begin(d)) return 0;
if (d->record == IVP_RECORD_EVENT) return casadi_ivp_request(d, IVP_EVENT_ADJ, IVP_RETREAT);
casadi_ivp_back_step_begin(d);
d->next = ERK_BACK_STAGE;
return casadi_erk_backward(d, e);
case ERK_BACK_STAGE:
if (d->stage == 0) {
d->t = d->t0;
d->next = IVP_RETREAT;
return casadi_erk_backward(d, e);
}
i = --d->stage;
rUi = d->rU + i * p->nr;
casadi_scal(p->nr, d->h, rUi);
casadi_ivp_stage_argument(d, i);
casadi_ivp_clear_vjp(d);
d->t_arg = d->t0 + p->alpha[i] * d->h;
d->y_arg = d->y_stage;
d->w = rUi;
return casadi_ivp_request(d, IVP_EVAL_VJP, ERK_BACK_SPREAD);
case ERK_BACK_SPREAD:
if (d->fail) return casadi_ivp_stop(d, IVP_EVAL_FAILED);
d->n_vjp++;
i = d->stage;
casadi_ivp_add_vjp(d, d->ry);
for (j = 0; j < i; ++j) {
if (p->a[i * s + j] != 0) casadi_axpy(p->nrx, p->a[i * s + j], d->vjp_x, d->rU + j * p->nr);
}
d->next = ERK_BACK_STAGE;
return casadi_erk_backward(d, e);
case IVP_IMPULSE:
if (casadi_ivp_impulse_begin(d)) {
casadi_ivp_seed_stages(d);
return casadi_ivp_stop(d, IVP_SUCCESS);
}
return 0;
default:
return 0;
}
}
int casadi_erk(struct casadi_ivp_data* d, struct casadi_erk_data* e) {
if (d->next == IVP_IMPULSE || d->next == IVP_RETREAT || d->next >= ERK_BACK_STAGE) {
return casadi_erk_backward(d, e);
}
return casadi_erk_forward(d, e);
}
/* Configuration this file was compiled with */
CASADI_SYMBOL_EXPORT void rk45_casadi_version(int* major, int* minor, int* patch) {
*major = 3;
*minor = 8;
*patch = 2;
}
CASADI_SYMBOL_EXPORT int rk45_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int rk45_casadi_real_size(void) { return (int) sizeof(casadi_real); }
static const casadi_int casadi_s0[2] = {0, 1};
static const casadi_int casadi_s1[3] = {7, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};
static const casadi_int casadi_s3[3] = {19, 1, 1};
static const casadi_int casadi_s4[4] = {7, 1, 0, 0};
static const casadi_int casadi_s5[4] = {1, 1, 0, 0};
static const casadi_int casadi_s6[4] = {19, 1, 0, 0};
static const casadi_real casadi_c0[49] =
{0., 0., 0., 0., 0., 0., 0., 2.2222222222222221e-01,
0., 0., 0., 0., 0., 0., 9.2773437500000000e-02, 2.1972656250000000e-01,
0., 0., 0., 0., 0., 7.4468624999999999e-01, -3.4916062499999998e+00, 3.5719200000000000e+00,
0., 0., 0., 0., 2.6613681355177952e+00, -1.3023809523809524e+01, 1.1682017166138619e+01, -3.6719482546593879e-01,
0., 0., 0., 2.8667876712328768e+00, -1.3844280821917808e+01, 1.2283823308650417e+01, -2.3202113342347097e-01, -7.4309024542014393e-02,
0., 0., 9.5303030303030306e-02, 0., 4.6607057529349077e-01, 6.1575078671044026e-01, -4.9314170832427734e-01, 3.1601731601731603e-01,
0.};
static const casadi_real casadi_c1[7] = {0., 2.2222222222222221e-01, 3.1250000000000000e-01, 8.2499999999999996e-01, 9.5238095238095233e-01, 1., 1.};
static const casadi_real casadi_c2[7] = {9.5303030303030306e-02, 0., 4.6607057529349077e-01, 6.1575078671044026e-01, -4.9314170832427734e-01, 3.1601731601731603e-01, 0.};
static const casadi_real casadi_c3[28] =
{1., 0., 0., 0., 0., 0., 0., -2.7845454545454547e+00,
0., 4.0198587119063580e+00, -4.1563178102954712e+00, 5.2132123451423604e+00, -3.7922077922077921e+00, 1.5000000000000000e+00, 2.9503030303030302e+00, 0.,
-6.1754351226387527e+00, 1.0775638767432705e+01, -1.2398991523581831e+01, 8.8484848484848477e+00, -4., -1.0704545454545455e+00, 0., 2.6216469860258855e+00,
-6.0035701704267925e+00, 6.6926374701151925e+00, -4.7402597402597406e+00, 2.5000000000000000e+00};
static const casadi_real casadi_c4[7] = {9.0337155371128346e-04, 0., -3.1482216823608199e-03, 2.3533727668404270e-02, -6.0004801270238307e-02, 5.0463353980116470e-02, -1.1747430249632892e-02};
static const casadi_real casadi_c5[1] = {1.};
static const casadi_real casadi_zeros[20] =
{0.};
/* rhsF:(t[0],x[7],z[0],p[20],u)->(ode[7],alg[0],quad[0]) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13;
a00=arg[3]? arg[3][19] : 0;
a01=arg[4]? arg[4][0] : 0;
a02=arg[3]? arg[3][16] : 0;
a03=arg[3]? arg[3][15] : 0;
a04=arg[3]? arg[3][14] : 0;
a05=arg[3]? arg[3][10] : 0;
a06=arg[3]? arg[3][11] : 0;
a07=arg[3]? arg[3][9] : 0;
a06=a06*a07;
a05=a05+a06;
a06=arg[3]? arg[3][2] : 0;
a08=arg[1]? arg[1][1] : 0;
a09=a06*a08;
a10=arg[1]? arg[1][0] : 0;
a09=a09+a10;
a05=a05*a09;
a09=arg[3]? arg[3][12] : 0;
a11=arg[3]? arg[3][13] : 0;
a11=a11*a07;
a09=a09+a11;
a11=arg[3]? arg[3][4] : 0;
a12=a09*a11;
a05=a05/a12;
a12=1.;
a13=arg[3]? arg[3][17] : 0;
a12=a12-a13;
a12=a05*a12;
a05=a04*a05;
a05=atan(a05);
a13=a13*a05;
a13=a13/a04;
a12=a12+a13;
a04=a04*a12;
a04=atan(a04);
a03=a03*a04;
a03=sin(a03);
a02=a02*a03;
a02=a02*a07;
a02=a02*a09;
a02=2.*a02;
a09=a01-a02;
a07=5.0000000000000000e-01;
a03=arg[3]? arg[3][6] : 0;
a07=a07*a03;
a03=arg[3]? arg[3][7] : 0;
a07=a07*a03;
a03=arg[3]? arg[3][3] : 0;
a04=a03*a08;
a04=a10-a04;
a04=a04/a11;
a04=atan(a04);
a07=a07*a04;
a12=arg[3]? arg[3][5] : 0;
a07=a07*a12;
a12=casadi_sq(a11);
a07=a07*a12;
a09=a09-a07;
a12=arg[3]? arg[3][8] : 0;
a12=a12*a04;
a09=a09-a12;
a04=arg[3]? arg[3][0] : 0;
a09=a09/a04;
a04=a08*a11;
a09=a09-a04;
a09=a00*a09;
if (res[0]!=0) res[0][0]=a09;
a07=a07*a03;
a01=a01*a03;
a02=a02*a06;
a01=a01+a02;
a07=a07-a01;
a12=a12*a03;
a07=a07+a12;
a12=arg[3]? arg[3][1] : 0;
a07=a07/a12;
a07=a00*a07;
if (res[0]!=0) res[0][1]=a07;
a07=a00*a10;
if (res[0]!=0) res[0][2]=a07;
a07=a00*a08;
if (res[0]!=0) res[0][3]=a07;
a07=arg[1]? arg[1][6] : 0;
a12=cos(a07);
a12=a11*a12;
a03=sin(a07);
a03=a10*a03;
a12=a12-a03;
a12=a00*a12;
if (res[0]!=0) res[0][4]=a12;
a12=sin(a07);
a11=a11*a12;
a07=cos(a07);
a10=a10*a07;
a11=a11+a10;
a11=a00*a11;
if (res[0]!=0) res[0][5]=a11;
a00=a00*a08;
if (res[0]!=0) res[0][6]=a00;
return 0;
}
/* nonlinear_rk45_step:(x0[7],z0[0],p[20],u,adj_xf[],adj_zf[],adj_qf[])->(xf[7],zf[0],qf[0],adj_x0[],adj_z0[],adj_p[],adj_u[]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_int j, k;
casadi_real *pv, **sres, *uv;
const casadi_real **sarg;
struct casadi_erk_data e;
struct casadi_erk_prob pe;
struct casadi_ivp_data d;
struct casadi_ivp_prob p;
/* Problem structure */
p.nx1 = 7;
p.nz1 = 0;
p.nq1 = 0;
p.np1 = 20;
p.nu1 = 1;
p.nfwd = 0;
p.nadj = 0;
p.n_stages = 7;
p.a = casadi_c0;
p.alpha = casadi_c1;
p.m = casadi_c2;
p.n_dense = 4;
p.m_dense = casadi_c3;
p.sp_jac[0] = 0;
p.sp_jac[1] = 0;
p.sp_jac[2] = 0;
p.sp_jac[3] = 0;
p.sp_jac[4] = 0;
p.sp_jac[5] = 0;
p.sp_jac[6] = 0;
p.sp_jac[7] = 0;
p.sp_jac[8] = 0;
p.tape_size = 0;
p.step_size = 0.;
p.nx_err = 7;
p.nz_err = 0;
p.nq_err = 0;
p.abstol = 1.0000000000000000e-13;
p.reltol = 9.9999999999999994e-12;
p.order_err = 4;
p.m_err = casadi_c4;
p.safety = 9.0000000000000002e-01;
p.fac_min = 2.0000000000000001e-01;
p.fac_max = 6.;
p.h_min = 1.0000000000000000e-14;
p.h_max = 0.;
p.h_init = 0.;
p.max_num_steps = 1000000;
p.ne = 0;
casadi_ivp_setup(&p);
/* Work vectors */
sarg = arg + 7; sres = res + 7;
pv = w; w += 20;
uv = w; w += 1;
d.prob = &p;
casadi_ivp_set_work(&d, &arg, &res, &iw, &w);
/* Method */
pe.fsal = 1;
e.prob = &pe;
e.nom = 0;
/* Initial state, parameters */
casadi_copy(arg[0], 7, d.y);
casadi_copy(arg[1], 0, d.y+7);
casadi_clear(d.y+7, 0);
casadi_copy(arg[2], 20, pv);
/* Forward integration: a run of steps per control group, as RuntimeIntegrator::eval */
for (j = 0; j < 1; ++j) {
casadi_copy(arg[3] ? arg[3] + j*1 : 0, 1, uv);
casadi_ivp_reset(&d, j ? casadi_c5[casadi_s0[j]-1] : 0., uv, j == 0);
for (k = casadi_s0[j]; k < casadi_s0[j+1]; ++k) {
casadi_ivp_advance(&d, casadi_c5[k], casadi_c5[casadi_s0[j+1]-1], 0);
while (casadi_erk(&d, &e)) {
switch (d.task) {
case IVP_EVAL_RHS:
sarg[0] = &d.t_arg;
sarg[1] = d.y_arg;
sarg[2] = d.y_arg+7;
sarg[3] = pv;
sarg[4] = d.u_step;
sres[0] = d.res;
sres[1] = d.res+7;
sres[2] = d.res+7;
if (casadi_f2(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
break;
case IVP_STEP_CONTROL:
casadi_ivp_control(&d);
break;
default: d.fail = 1;
}
}
if (d.status != IVP_SUCCESS) return 1;
if (res[0]) casadi_copy(d.y_out, 7, res[0] + k*7);
if (res[1]) casadi_copy(d.y_out+7, 0, res[1] + k*0);
if (res[2]) casadi_copy(d.y_out+7, 0, res[2] + k*0);
}
}
return 0;
}
/* nonlinear_rk45:(x0[7],u,p[19],h)->(xf[7]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_int i;
casadi_real **res1=res+1, *rr, *w0=w+169, w3, *w4=w+176, *w6=w+196;
const casadi_real **arg1=arg+4, *cs, *wr2;
/* #0: @0 = input[0][0] */
casadi_copy(arg[0], 7, w0);
/* #1: @1 = 0x1 */
/* #2: @2 = input[2][0] */
wr2 = arg[2] ? arg[2] : casadi_zeros;
/* #3: @3 = input[3][0] */
w3 = arg[3] ? arg[3][0] : 0;
/* #4: @4 = vertcat(@2, @3) */
rr=w4;
for (i=0, cs=wr2; i<19; ++i) *rr++ = *cs++;
*rr++ = w3;
/* #5: @3 = input[1][0] */
w3 = arg[1] ? arg[1][0] : 0;
/* #6: @5 = 0x0 */
/* #7: {@6, NULL, NULL, NULL, NULL, NULL, NULL} = nonlinear_rk45_step(@0, @1, @4, @3, @5, @5, @5) */
arg1[0]=w0;
arg1[1]=0;
arg1[2]=w4;
arg1[3]=&w3;
arg1[4]=0;
arg1[5]=0;
arg1[6]=0;
res1[0]=w6;
res1[1]=0;
res1[2]=0;
res1[3]=0;
res1[4]=0;
res1[5]=0;
res1[6]=0;
if (casadi_f1(arg1, res1, iw, w, 0)) return 1;
/* #8: output[0][0] = @6 */
casadi_copy(w6, 7, res[0]);
return 0;
}
CASADI_SYMBOL_EXPORT int nonlinear_rk45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f0(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int nonlinear_rk45_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void nonlinear_rk45_release(int mem) {
}
CASADI_SYMBOL_EXPORT void nonlinear_rk45_incref(void) {
}
CASADI_SYMBOL_EXPORT void nonlinear_rk45_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int nonlinear_rk45_n_in(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_int nonlinear_rk45_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real nonlinear_rk45_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* nonlinear_rk45_name_in(casadi_int i) {
switch (i) {
case 0: return "x0";
case 1: return "u";
case 2: return "p";
case 3: return "h";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* nonlinear_rk45_name_out(casadi_int i) {
switch (i) {
case 0: return "xf";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* nonlinear_rk45_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s1;
case 1: return casadi_s2;
case 2: return casadi_s3;
case 3: return casadi_s2;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* nonlinear_rk45_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s1;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int nonlinear_rk45_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 16;
if (sz_res) *sz_res = 12;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 203;
return 0;
}
CASADI_SYMBOL_EXPORT int nonlinear_rk45_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
if (sz_res) *sz_res = 12*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 203*sizeof(casadi_real);
return 0;
}
/* rhsF:(t[0],x[7],z[0],p[20],u)->(ode[7],alg[0],quad[0]) */
static int casadi_f6(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13;
a00=arg[3]? arg[3][19] : 0;
a01=arg[4]? arg[4][0] : 0;
a02=arg[3]? arg[3][16] : 0;
a03=arg[3]? arg[3][15] : 0;
a04=arg[3]? arg[3][14] : 0;
a05=arg[3]? arg[3][10] : 0;
a06=arg[3]? arg[3][11] : 0;
a07=arg[3]? arg[3][9] : 0;
a06=a06*a07;
a05=a05+a06;
a06=arg[3]? arg[3][2] : 0;
a08=arg[1]? arg[1][1] : 0;
a09=a06*a08;
a10=arg[1]? arg[1][0] : 0;
a09=a09+a10;
a05=a05*a09;
a09=arg[3]? arg[3][12] : 0;
a11=arg[3]? arg[3][13] : 0;
a11=a11*a07;
a09=a09+a11;
a11=arg[3]? arg[3][4] : 0;
a12=a09*a11;
a05=a05/a12;
a12=1.;
a13=arg[3]? arg[3][17] : 0;
a12=a12-a13;
a12=a05*a12;
a05=a04*a05;
a05=atan(a05);
a13=a13*a05;
a13=a13/a04;
a12=a12+a13;
a04=a04*a12;
a04=atan(a04);
a03=a03*a04;
a03=sin(a03);
a02=a02*a03;
a02=a02*a07;
a02=a02*a09;
a02=2.*a02;
a09=a01-a02;
a07=5.0000000000000000e-01;
a03=arg[3]? arg[3][6] : 0;
a07=a07*a03;
a03=arg[3]? arg[3][7] : 0;
a07=a07*a03;
a03=arg[3]? arg[3][3] : 0;
a04=a03*a08;
a04=a10-a04;
a04=a04/a11;
a04=atan(a04);
a07=a07*a04;
a12=arg[3]? arg[3][5] : 0;
a07=a07*a12;
a12=casadi_sq(a11);
a07=a07*a12;
a09=a09-a07;
a12=arg[3]? arg[3][8] : 0;
a12=a12*a04;
a09=a09-a12;
a04=arg[3]? arg[3][0] : 0;
a09=a09/a04;
a04=a08*a11;
a09=a09-a04;
a09=a00*a09;
if (res[0]!=0) res[0][0]=a09;
a07=a07*a03;
a01=a01*a03;
a02=a02*a06;
a01=a01+a02;
a07=a07-a01;
a12=a12*a03;
a07=a07+a12;
a12=arg[3]? arg[3][1] : 0;
a07=a07/a12;
a07=a00*a07;
if (res[0]!=0) res[0][1]=a07;
a07=a00*a10;
if (res[0]!=0) res[0][2]=a07;
a07=a00*a08;
if (res[0]!=0) res[0][3]=a07;
a07=arg[1]? arg[1][6] : 0;
a12=cos(a07);
a12=a11*a12;
a03=sin(a07);
a03=a10*a03;
a12=a12-a03;
a12=a00*a12;
if (res[0]!=0) res[0][4]=a12;
a12=sin(a07);
a11=a11*a12;
a07=cos(a07);
a10=a10*a07;
a11=a11+a10;
a11=a00*a11;
if (res[0]!=0) res[0][5]=a11;
a00=a00*a08;
if (res[0]!=0) res[0][6]=a00;
return 0;
}
/* fwd1_rhsF:(t[0],x[7],z[0],p[20],u,out_ode[7x1,0nz],out_alg[0],out_quad[0],fwd_t[0],fwd_x[7],fwd_z[0],fwd_p[20],fwd_u)->(fwd_ode[7],fwd_alg[0],fwd_quad[0]) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55;
a00=arg[4]? arg[4][0] : 0;
a01=arg[3]? arg[3][16] : 0;
a02=arg[3]? arg[3][15] : 0;
a03=arg[3]? arg[3][14] : 0;
a04=arg[3]? arg[3][10] : 0;
a05=arg[3]? arg[3][11] : 0;
a06=arg[3]? arg[3][9] : 0;
a07=a05*a06;
a04=a04+a07;
a07=arg[3]? arg[3][2] : 0;
a08=arg[1]? arg[1][1] : 0;
a09=a07*a08;
a10=arg[1]? arg[1][0] : 0;
a09=a09+a10;
a11=a04*a09;
a12=arg[3]? arg[3][12] : 0;
a13=arg[3]? arg[3][13] : 0;
a14=a13*a06;
a12=a12+a14;
a14=arg[3]? arg[3][4] : 0;
a15=a12*a14;
a11=a11/a15;
a16=1.;
a17=arg[3]? arg[3][17] : 0;
a18=a16-a17;
a19=a11*a18;
a20=a03*a11;
a21=atan(a20);
a22=a17*a21;
a22=a22/a03;
a19=a19+a22;
a23=a03*a19;
a24=atan(a23);
a25=a02*a24;
a26=sin(a25);
a27=a01*a26;
a28=a27*a06;
a29=a28*a12;
a29=2.*a29;
a30=a00-a29;
a31=5.0000000000000000e-01;
a32=arg[3]? arg[3][6] : 0;
a32=a31*a32;
a33=arg[3]? arg[3][7] : 0;
a34=a32*a33;
a35=arg[3]? arg[3][3] : 0;
a36=a35*a08;
a36=a10-a36;
a36=a36/a14;
a37=atan(a36);
a38=a34*a37;
a39=arg[3]? arg[3][5] : 0;
a40=a38*a39;
a41=casadi_sq(a14);
a42=a40*a41;
a30=a30-a42;
a43=arg[3]? arg[3][8] : 0;
a44=a43*a37;
a30=a30-a44;
a45=arg[3]? arg[3][0] : 0;
a30=a30/a45;
a46=a08*a14;
a46=a30-a46;
a47=arg[11]? arg[11][19] : 0;
a46=a46*a47;
a48=arg[3]? arg[3][19] : 0;
a49=arg[12]? arg[12][0] : 0;
a50=arg[11]? arg[11][16] : 0;
a26=a26*a50;
a25=cos(a25);
a50=arg[11]? arg[11][15] : 0;
a24=a24*a50;
a50=arg[11]? arg[11][14] : 0;
a19=a19*a50;
a51=arg[11]? arg[11][10] : 0;
a52=arg[11]? arg[11][11] : 0;
a52=a06*a52;
a53=arg[11]? arg[11][9] : 0;
a05=a05*a53;
a52=a52+a05;
a51=a51+a52;
a09=a09*a51;
a51=arg[11]? arg[11][2] : 0;
a52=a08*a51;
a05=arg[9]? arg[9][1] : 0;
a54=a07*a05;
a52=a52+a54;
a54=arg[9]? arg[9][0] : 0;
a52=a52+a54;
a04=a04*a52;
a09=a09+a04;
a09=a09/a15;
a15=a11/a15;
a04=arg[11]? arg[11][12] : 0;
a52=arg[11]? arg[11][13] : 0;
a52=a06*a52;
a13=a13*a53;
a52=a52+a13;
a04=a04+a52;
a52=a14*a04;
a13=arg[11]? arg[11][4] : 0;
a55=a12*a13;
a52=a52+a55;
a15=a15*a52;
a09=a09-a15;
a18=a18*a09;
a15=arg[11]? arg[11][17] : 0;
a52=a11*a15;
a18=a18-a52;
a21=a21*a15;
a11=a11*a50;
a09=a03*a09;
a11=a11+a09;
a20=casadi_sq(a20);
a20=a16+a20;
a11=a11/a20;
a17=a17*a11;
a21=a21+a17;
a21=a21/a03;
a22=a22/a03;
a22=a22*a50;
a21=a21-a22;
a18=a18+a21;
a03=a03*a18;
a19=a19+a03;
a23=casadi_sq(a23);
a23=a16+a23;
a19=a19/a23;
a02=a02*a19;
a24=a24+a02;
a25=a25*a24;
a01=a01*a25;
a26=a26+a01;
a06=a06*a26;
a27=a27*a53;
a06=a06+a27;
a12=a12*a06;
a28=a28*a04;
a12=a12+a28;
a12=2.*a12;
a28=a49-a12;
a04=arg[11]? arg[11][6] : 0;
a31=a31*a04;
a33=a33*a31;
a31=arg[11]? arg[11][7] : 0;
a32=a32*a31;
a33=a33+a32;
a33=a37*a33;
a32=arg[11]? arg[11][3] : 0;
a31=a08*a32;
a04=a35*a05;
a31=a31+a04;
a31=a54-a31;
a31=a31/a14;
a04=a36/a14;
a04=a04*a13;
a31=a31-a04;
a36=casadi_sq(a36);
a16=a16+a36;
a31=a31/a16;
a34=a34*a31;
a33=a33+a34;
a39=a39*a33;
a33=arg[11]? arg[11][5] : 0;
a38=a38*a33;
a39=a39+a38;
a41=a41*a39;
a39=2.*a14;
a39=a39*a13;
a40=a40*a39;
a41=a41+a40;
a28=a28-a41;
a40=arg[11]? arg[11][8] : 0;
a37=a37*a40;
a43=a43*a31;
a37=a37+a43;
a28=a28-a37;
a28=a28/a45;
a30=a30/a45;
a45=arg[11]? arg[11][0] : 0;
a30=a30*a45;
a28=a28-a30;
a30=a14*a05;
a45=a08*a13;
a30=a30+a45;
a28=a28-a30;
a28=a48*a28;
a46=a46+a28;
if (res[0]!=0) res[0][0]=a46;
a46=a42*a35;
a28=a00*a35;
a30=a29*a07;
a28=a28+a30;
a46=a46-a28;
a28=a44*a35;
a46=a46+a28;
a28=arg[3]? arg[3][1] : 0;
a46=a46/a28;
a30=a46*a47;
a41=a35*a41;
a42=a42*a32;
a41=a41+a42;
a49=a35*a49;
a00=a00*a32;
a49=a49+a00;
a07=a07*a12;
a29=a29*a51;
a07=a07+a29;
a49=a49+a07;
a41=a41-a49;
a35=a35*a37;
a44=a44*a32;
a35=a35+a44;
a41=a41+a35;
a41=a41/a28;
a46=a46/a28;
a28=arg[11]? arg[11][1] : 0;
a46=a46*a28;
a41=a41-a46;
a41=a48*a41;
a30=a30+a41;
if (res[0]!=0) res[0][1]=a30;
a30=a10*a47;
a41=a48*a54;
a30=a30+a41;
if (res[0]!=0) res[0][2]=a30;
a30=a08*a47;
a41=a48*a05;
a30=a30+a41;
if (res[0]!=0) res[0][3]=a30;
a30=arg[1]? arg[1][6] : 0;
a41=cos(a30);
a46=a14*a41;
a28=sin(a30);
a35=a10*a28;
a46=a46-a35;
a46=a46*a47;
a41=a41*a13;
a35=sin(a30);
a44=arg[9]? arg[9][6] : 0;
a35=a35*a44;
a35=a14*a35;
a41=a41-a35;
a28=a28*a54;
a35=cos(a30);
a35=a35*a44;
a35=a10*a35;
a28=a28+a35;
a41=a41-a28;
a41=a48*a41;
a46=a46+a41;
if (res[0]!=0) res[0][4]=a46;
a46=sin(a30);
a41=a14*a46;
a28=cos(a30);
a35=a10*a28;
a41=a41+a35;
a41=a41*a47;
a46=a46*a13;
a13=cos(a30);
a13=a13*a44;
a14=a14*a13;
a46=a46+a14;
a28=a28*a54;
a30=sin(a30);
a30=a30*a44;
a10=a10*a30;
a28=a28-a10;
a46=a46+a28;
a46=a48*a46;
a41=a41+a46;
if (res[0]!=0) res[0][5]=a41;
a08=a08*a47;
a48=a48*a05;
a08=a08+a48;
if (res[0]!=0) res[0][6]=a08;
return 0;
}
/* fsens1_nonlinear_rk45_step:(x0[7x2],z0[0x2],p[20x2],u[1x2],adj_xf[],adj_zf[],adj_qf[])->(xf[7x2],zf[0x2],qf[0x2],adj_x0[],adj_z0[],adj_p[],adj_u[]) */
static int casadi_f5(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_int j, k;
casadi_real *pv, **sres, *uv;
const casadi_real **sarg;
struct casadi_erk_data e;
struct casadi_erk_prob pe;
struct casadi_ivp_data d;
struct casadi_ivp_prob p;
/* Problem structure */
p.nx1 = 7;
p.nz1 = 0;
p.nq1 = 0;
p.np1 = 20;
p.nu1 = 1;
p.nfwd = 1;
p.nadj = 0;
p.n_stages = 7;
p.a = casadi_c0;
p.alpha = casadi_c1;
p.m = casadi_c2;
p.n_dense = 4;
p.m_dense = casadi_c3;
p.sp_jac[0] = 0;
p.sp_jac[1] = 0;
p.sp_jac[2] = 0;
p.sp_jac[3] = 0;
p.sp_jac[4] = 0;
p.sp_jac[5] = 0;
p.sp_jac[6] = 0;
p.sp_jac[7] = 0;
p.sp_jac[8] = 0;
p.tape_size = 0;
p.step_size = 0.;
p.nx_err = 7;
p.nz_err = 0;
p.nq_err = 0;
p.abstol = 1.0000000000000000e-13;
p.reltol = 9.9999999999999994e-12;
p.order_err = 4;
p.m_err = casadi_c4;
p.safety = 9.0000000000000002e-01;
p.fac_min = 2.0000000000000001e-01;
p.fac_max = 6.;
p.h_min = 1.0000000000000000e-14;
p.h_max = 0.;
p.h_init = 0.;
p.max_num_steps = 1000000;
p.ne = 0;
casadi_ivp_setup(&p);
/* Work vectors */
sarg = arg + 7; sres = res + 7;
pv = w; w += 40;
uv = w; w += 2;
d.prob = &p;
casadi_ivp_set_work(&d, &arg, &res, &iw, &w);
/* Method */
pe.fsal = 1;
e.prob = &pe;
e.nom = 0;
/* Initial state, parameters */
casadi_copy(arg[0], 14, d.y);
casadi_copy(arg[1], 0, d.y+14);
casadi_clear(d.y+14, 0);
casadi_copy(arg[2], 40, pv);
/* Forward integration: a run of steps per control group, as RuntimeIntegrator::eval */
for (j = 0; j < 1; ++j) {
casadi_copy(arg[3] ? arg[3] + j*2 : 0, 2, uv);
casadi_ivp_reset(&d, j ? casadi_c5[casadi_s0[j]-1] : 0., uv, j == 0);
for (k = casadi_s0[j]; k < casadi_s0[j+1]; ++k) {
casadi_ivp_advance(&d, casadi_c5[k], casadi_c5[casadi_s0[j+1]-1], 0);
while (casadi_erk(&d, &e)) {
switch (d.task) {
case IVP_EVAL_RHS:
sarg[0] = &d.t_arg;
sarg[1] = d.y_arg;
sarg[2] = d.y_arg+14;
sarg[3] = pv;
sarg[4] = d.u_step;
sres[0] = d.res;
sres[1] = d.res+14;
sres[2] = d.res+14;
if (casadi_f6(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
sarg[5] = d.res;
sarg[6] = d.res+14;
sarg[7] = d.res+14;
sarg[8] = 0;
sarg[9] = d.y_arg+7;
sarg[10] = d.y_arg+14;
sarg[11] = pv+20;
sarg[12] = d.u_step+1;
sres[0] = d.res+7;
if (casadi_f7(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
break;
case IVP_STEP_CONTROL:
casadi_ivp_control(&d);
break;
default: d.fail = 1;
}
}
if (d.status != IVP_SUCCESS) return 1;
if (res[0]) casadi_copy(d.y_out, 14, res[0] + k*14);
if (res[1]) casadi_copy(d.y_out+14, 0, res[1] + k*0);
if (res[2]) casadi_copy(d.y_out+14, 0, res[2] + k*0);
}
}
return 0;
}
/* fwd1_nonlinear_rk45_step:(x0[7],z0[0],p[20],u,adj_xf[],adj_zf[],adj_qf[],out_xf[7x1,0nz],out_zf[0],out_qf[0],out_adj_x0[],out_adj_z0[],out_adj_p[],out_adj_u[],fwd_x0[7],fwd_z0[0],fwd_p[20],fwd_u,fwd_adj_xf[],fwd_adj_zf[],fwd_adj_qf[])->(fwd_xf[7],fwd_zf[0],fwd_qf[0],fwd_adj_x0[],fwd_adj_z0[],fwd_adj_p[],fwd_adj_u[]) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_int i;
casadi_real **res1=res+7, *rr, *w00=w+359, *w01=w+366, *w02=w+373, *w06=w+387, w07, w08, *w09=w+427, *w13=w+429;
const casadi_real **arg1=arg+21, *cs, *wr04, *wr05;
/* #0: @0 = input[0][0] */
casadi_copy(arg[0], 7, w00);
/* #1: @1 = input[14][0] */
casadi_copy(arg[14], 7, w01);
/* #2: @2 = vertcat(@0, @1) */
rr=w02;
for (i=0, cs=w00; i<7; ++i) *rr++ = *cs++;
for (i=0, cs=w01; i<7; ++i) *rr++ = *cs++;
/* #3: @2 = reshape(@2) */
/* #4: @3 = 0x2 */
/* #5: @4 = input[2][0] */
wr04 = arg[2] ? arg[2] : casadi_zeros;
/* #6: @5 = input[16][0] */
wr05 = arg[16] ? arg[16] : casadi_zeros;
/* #7: @6 = vertcat(@4, @5) */
rr=w06;
for (i=0, cs=wr04; i<20; ++i) *rr++ = *cs++;
for (i=0, cs=wr05; i<20; ++i) *rr++ = *cs++;
/* #8: @6 = reshape(@6) */
/* #9: @7 = input[3][0] */
w07 = arg[3] ? arg[3][0] : 0;
/* #10: @8 = input[17][0] */
w08 = arg[17] ? arg[17][0] : 0;
/* #11: @9 = vertcat(@7, @8) */
rr=w09;
*rr++ = w07;
*rr++ = w08;
/* #12: @9 = @9' */
/* #13: @10 = 0x0 */
/* #14: @11 = 0x0 */
/* #15: @12 = 0x0 */
/* #16: {@13, NULL, NULL, NULL, NULL, NULL, NULL} = fsens1_nonlinear_rk45_step(@2, @3, @6, @9, @10, @11, @12) */
arg1[0]=w02;
arg1[1]=0;
arg1[2]=w06;
arg1[3]=w09;
arg1[4]=0;
arg1[5]=0;
arg1[6]=0;
res1[0]=w13;
res1[1]=0;
res1[2]=0;
res1[3]=0;
res1[4]=0;
res1[5]=0;
res1[6]=0;
if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
/* #17: {NULL, @0} = horzsplit(@13) */
casadi_copy(w13+7, 7, w00);
/* #18: output[0][0] = @0 */
casadi_copy(w00, 7, res[0]);
return 0;
}
/* fwd1_nonlinear_rk45:(x0[7],u,p[19],h,out_xf[7x1,0nz],fwd_x0[7],fwd_u,fwd_p[19],fwd_h)->(fwd_xf[7]) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_int i;
casadi_real **res1=res+1, *rr, *w00=w+485, w03, *w04=w+492, *w09=w+512, w11, *w12=w+519, *w13=w+539;
const casadi_real **arg1=arg+9, *cs, *wr02;
/* #0: @0 = input[0][0] */
casadi_copy(arg[0], 7, w00);
/* #1: @1 = 0x1 */
/* #2: @2 = input[2][0] */
wr02 = arg[2] ? arg[2] : casadi_zeros;
/* #3: @3 = input[3][0] */
w03 = arg[3] ? arg[3][0] : 0;
/* #4: @4 = vertcat(@2, @3) */
rr=w04;
for (i=0, cs=wr02; i<19; ++i) *rr++ = *cs++;
*rr++ = w03;
/* #5: @3 = input[1][0] */
w03 = arg[1] ? arg[1][0] : 0;
/* #6: @5 = 0x0 */
/* #7: @6 = zeros(7x1,0nz) */
/* #8: @7 = 0x1 */
/* #9: @8 = 0x1 */
/* #10: @9 = input[5][0] */
casadi_copy(arg[5], 7, w09);
/* #11: @10 = 0x1 */
/* #12: @2 = input[7][0] */
wr02 = arg[7] ? arg[7] : casadi_zeros;
/* #13: @11 = input[8][0] */
w11 = arg[8] ? arg[8][0] : 0;
/* #14: @12 = vertcat(@2, @11) */
rr=w12;
for (i=0, cs=wr02; i<19; ++i) *rr++ = *cs++;
*rr++ = w11;
/* #15: @11 = input[6][0] */
w11 = arg[6] ? arg[6][0] : 0;
/* #16: {@13, NULL, NULL, NULL, NULL, NULL, NULL} = fwd1_nonlinear_rk45_step(@0, @1, @4, @3, @5, @5, @5, @6, @7, @8, @5, @5, @5, @5, @9, @10, @12, @11, @5, @5, @5) */
arg1[0]=w00;
arg1[1]=0;
arg1[2]=w04;
arg1[3]=&w03;
arg1[4]=0;
arg1[5]=0;
arg1[6]=0;
arg1[7]=0;
arg1[8]=0;
arg1[9]=0;
arg1[10]=0;
arg1[11]=0;
arg1[12]=0;
arg1[13]=0;
arg1[14]=w09;
arg1[15]=0;
arg1[16]=w12;
arg1[17]=&w11;
arg1[18]=0;
arg1[19]=0;
arg1[20]=0;
res1[0]=w13;
res1[1]=0;
res1[2]=0;
res1[3]=0;
res1[4]=0;
res1[5]=0;
res1[6]=0;
if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
/* #17: output[0][0] = @13 */
casadi_copy(w13, 7, res[0]);
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_nonlinear_rk45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f3(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_nonlinear_rk45_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_nonlinear_rk45_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_nonlinear_rk45_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_nonlinear_rk45_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_nonlinear_rk45_n_in(void) { return 9;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_nonlinear_rk45_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_nonlinear_rk45_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_nonlinear_rk45_name_in(casadi_int i) {
switch (i) {
case 0: return "x0";
case 1: return "u";
case 2: return "p";
case 3: return "h";
case 4: return "out_xf";
case 5: return "fwd_x0";
case 6: return "fwd_u";
case 7: return "fwd_p";
case 8: return "fwd_h";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_nonlinear_rk45_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_xf";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_nonlinear_rk45_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s1;
case 1: return casadi_s2;
case 2: return casadi_s3;
case 3: return casadi_s2;
case 4: return casadi_s4;
case 5: return casadi_s1;
case 6: return casadi_s2;
case 7: return casadi_s3;
case 8: return casadi_s2;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_nonlinear_rk45_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s1;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_nonlinear_rk45_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 50;
if (sz_res) *sz_res = 19;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 546;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_nonlinear_rk45_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 50*sizeof(const casadi_real*);
if (sz_res) *sz_res = 19*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 546*sizeof(casadi_real);
return 0;
}
/* rhsF:(t[0],x[7],z[0],p[20],u)->(ode[7],alg[0],quad[0]) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13;
a00=arg[3]? arg[3][19] : 0;
a01=arg[4]? arg[4][0] : 0;
a02=arg[3]? arg[3][16] : 0;
a03=arg[3]? arg[3][15] : 0;
a04=arg[3]? arg[3][14] : 0;
a05=arg[3]? arg[3][10] : 0;
a06=arg[3]? arg[3][11] : 0;
a07=arg[3]? arg[3][9] : 0;
a06=a06*a07;
a05=a05+a06;
a06=arg[3]? arg[3][2] : 0;
a08=arg[1]? arg[1][1] : 0;
a09=a06*a08;
a10=arg[1]? arg[1][0] : 0;
a09=a09+a10;
a05=a05*a09;
a09=arg[3]? arg[3][12] : 0;
a11=arg[3]? arg[3][13] : 0;
a11=a11*a07;
a09=a09+a11;
a11=arg[3]? arg[3][4] : 0;
a12=a09*a11;
a05=a05/a12;
a12=1.;
a13=arg[3]? arg[3][17] : 0;
a12=a12-a13;
a12=a05*a12;
a05=a04*a05;
a05=atan(a05);
a13=a13*a05;
a13=a13/a04;
a12=a12+a13;
a04=a04*a12;
a04=atan(a04);
a03=a03*a04;
a03=sin(a03);
a02=a02*a03;
a02=a02*a07;
a02=a02*a09;
a02=2.*a02;
a09=a01-a02;
a07=5.0000000000000000e-01;
a03=arg[3]? arg[3][6] : 0;
a07=a07*a03;
a03=arg[3]? arg[3][7] : 0;
a07=a07*a03;
a03=arg[3]? arg[3][3] : 0;
a04=a03*a08;
a04=a10-a04;
a04=a04/a11;
a04=atan(a04);
a07=a07*a04;
a12=arg[3]? arg[3][5] : 0;
a07=a07*a12;
a12=casadi_sq(a11);
a07=a07*a12;
a09=a09-a07;
a12=arg[3]? arg[3][8] : 0;
a12=a12*a04;
a09=a09-a12;
a04=arg[3]? arg[3][0] : 0;
a09=a09/a04;
a04=a08*a11;
a09=a09-a04;
a09=a00*a09;
if (res[0]!=0) res[0][0]=a09;
a07=a07*a03;
a01=a01*a03;
a02=a02*a06;
a01=a01+a02;
a07=a07-a01;
a12=a12*a03;
a07=a07+a12;
a12=arg[3]? arg[3][1] : 0;
a07=a07/a12;
a07=a00*a07;
if (res[0]!=0) res[0][1]=a07;
a07=a00*a10;
if (res[0]!=0) res[0][2]=a07;
a07=a00*a08;
if (res[0]!=0) res[0][3]=a07;
a07=arg[1]? arg[1][6] : 0;
a12=cos(a07);
a12=a11*a12;
a03=sin(a07);
a03=a10*a03;
a12=a12-a03;
a12=a00*a12;
if (res[0]!=0) res[0][4]=a12;
a12=sin(a07);
a11=a11*a12;
a07=cos(a07);
a10=a10*a07;
a11=a11+a10;
a11=a00*a11;
if (res[0]!=0) res[0][5]=a11;
a00=a00*a08;
if (res[0]!=0) res[0][6]=a00;
return 0;
}
/* vjpB:(t[0],x[7],z[0],p[20],u,out_ode[7x1,0nz],out_alg[0],out_quad[0],out_zero[0],adj_ode[7],adj_alg[0],adj_quad[0],adj_zero[0])->(adj_x[7],adj_z[0],adj_p[20],adj_u) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62, a63, a64, a65, a66, a67;
a00=arg[1]? arg[1][6] : 0;
a01=cos(a00);
a02=arg[3]? arg[3][19] : 0;
a03=arg[9]? arg[9][5] : 0;
a04=a02*a03;
a05=a01*a04;
a06=sin(a00);
a07=arg[9]? arg[9][4] : 0;
a08=a02*a07;
a09=a06*a08;
a05=a05-a09;
a09=arg[9]? arg[9][2] : 0;
a10=a02*a09;
a05=a05+a10;
a10=arg[3]? arg[3][8] : 0;
a11=arg[3]? arg[3][3] : 0;
a12=arg[9]? arg[9][1] : 0;
a13=a02*a12;
a14=arg[3]? arg[3][1] : 0;
a15=a13/a14;
a16=a11*a15;
a17=arg[9]? arg[9][0] : 0;
a18=a02*a17;
a19=arg[3]? arg[3][0] : 0;
a20=a18/a19;
a16=a16-a20;
a21=a10*a16;
a22=5.0000000000000000e-01;
a23=arg[3]? arg[3][6] : 0;
a23=a22*a23;
a24=arg[3]? arg[3][7] : 0;
a25=a23*a24;
a26=arg[3]? arg[3][5] : 0;
a27=arg[3]? arg[3][4] : 0;
a28=casadi_sq(a27);
a29=a11*a15;
a29=a29-a20;
a30=a28*a29;
a31=a26*a30;
a32=a25*a31;
a21=a21+a32;
a32=1.;
a33=arg[1]? arg[1][0] : 0;
a34=arg[1]? arg[1][1] : 0;
a35=a11*a34;
a35=a33-a35;
a35=a35/a27;
a36=casadi_sq(a35);
a36=a32+a36;
a21=a21/a36;
a36=a21/a27;
a05=a05+a36;
a37=arg[3]? arg[3][10] : 0;
a38=arg[3]? arg[3][11] : 0;
a39=arg[3]? arg[3][9] : 0;
a40=a38*a39;
a37=a37+a40;
a40=arg[3]? arg[3][14] : 0;
a41=arg[3]? arg[3][17] : 0;
a42=arg[3]? arg[3][15] : 0;
a43=arg[3]? arg[3][2] : 0;
a44=a43*a34;
a44=a44+a33;
a45=a37*a44;
a46=arg[3]? arg[3][12] : 0;
a47=arg[3]? arg[3][13] : 0;
a48=a47*a39;
a46=a46+a48;
a48=a46*a27;
a45=a45/a48;
a49=a32-a41;
a50=a45*a49;
a51=a40*a45;
a52=atan(a51);
a53=a41*a52;
a53=a53/a40;
a50=a50+a53;
a54=a40*a50;
a55=atan(a54);
a56=a42*a55;
a57=cos(a56);
a58=arg[3]? arg[3][16] : 0;
a59=a43*a15;
a59=a59+a20;
a59=-a59;
a59=2.*a59;
a60=a46*a59;
a61=a39*a60;
a62=a58*a61;
a57=a57*a62;
a42=a42*a57;
a54=casadi_sq(a54);
a54=a32+a54;
a42=a42/a54;
a41=a41*a42;
a51=casadi_sq(a51);
a32=a32+a51;
a41=a41/a32;
a32=a40*a41;
a51=a40*a42;
a49=a49*a51;
a32=a32+a49;
a49=a32/a48;
a37=a37*a49;
a05=a05+a37;
if (res[0]!=0) res[0][0]=a05;
a05=arg[9]? arg[9][6] : 0;
a54=a02*a05;
a62=arg[9]? arg[9][3] : 0;
a02=a02*a62;
a54=a54+a02;
a02=a27*a18;
a54=a54-a02;
a02=a11*a36;
a54=a54-a02;
a02=a43*a37;
a54=a54+a02;
if (res[0]!=0) res[0][1]=a54;
a54=0.;
if (res[0]!=0) res[0][2]=a54;
if (res[0]!=0) res[0][3]=a54;
if (res[0]!=0) res[0][4]=a54;
if (res[0]!=0) res[0][5]=a54;
a02=cos(a00);
a63=a27*a04;
a02=a02*a63;
a63=sin(a00);
a64=a33*a04;
a63=a63*a64;
a02=a02-a63;
a63=cos(a00);
a64=a33*a08;
a63=a63*a64;
a02=a02-a63;
a63=sin(a00);
a64=a27*a08;
a63=a63*a64;
a02=a02-a63;
if (res[0]!=0) res[0][6]=a02;
a02=arg[4]? arg[4][0] : 0;
a56=sin(a56);
a58=a58*a56;
a63=a58*a39;
a64=a63*a46;
a64=2.*a64;
a65=a02-a64;
a66=atan(a35);
a25=a25*a66;
a26=a25*a26;
a28=a26*a28;
a65=a65-a28;
a10=a10*a66;
a65=a65-a10;
a65=a65/a19;
a19=a65/a19;
a19=a19*a18;
a19=-a19;
if (res[2]!=0) res[2][0]=a19;
a19=a28*a11;
a67=a02*a11;
a43=a64*a43;
a67=a67+a43;
a19=a19-a67;
a67=a10*a11;
a19=a19+a67;
a19=a19/a14;
a14=a19/a14;
a14=a14*a13;
a14=-a14;
if (res[2]!=0) res[2][1]=a14;
a37=a34*a37;
a64=a64*a15;
a37=a37-a64;
if (res[2]!=0) res[2][2]=a37;
a10=a10*a15;
a02=a02*a15;
a10=a10-a02;
a28=a28*a15;
a10=a10+a28;
a36=a34*a36;
a10=a10-a36;
if (res[2]!=0) res[2][3]=a10;
a10=sin(a00);
a04=a10*a04;
a00=cos(a00);
a08=a00*a08;
a04=a04+a08;
a18=a34*a18;
a04=a04-a18;
a18=2.*a27;
a26=a26*a29;
a18=a18*a26;
a04=a04+a18;
a35=a35/a27;
a35=a35*a21;
a04=a04-a35;
a48=a45/a48;
a48=a48*a32;
a46=a46*a48;
a04=a04-a46;
if (res[2]!=0) res[2][4]=a04;
a25=a25*a30;
if (res[2]!=0) res[2][5]=a25;
a31=a66*a31;
a24=a24*a31;
a22=a22*a24;
if (res[2]!=0) res[2][6]=a22;
a23=a23*a31;
if (res[2]!=0) res[2][7]=a23;
a66=a66*a16;
if (res[2]!=0) res[2][8]=a66;
a58=a58*a60;
a63=a63*a59;
a48=a27*a48;
a63=a63-a48;
a47=a47*a63;
a58=a58+a47;
a44=a44*a49;
a38=a38*a44;
a58=a58+a38;
if (res[2]!=0) res[2][9]=a58;
if (res[2]!=0) res[2][10]=a44;
a44=a39*a44;
if (res[2]!=0) res[2][11]=a44;
if (res[2]!=0) res[2][12]=a63;
a39=a39*a63;
if (res[2]!=0) res[2][13]=a39;
a50=a50*a42;
a53=a53/a40;
a53=a53*a51;
a50=a50-a53;
a41=a45*a41;
a50=a50+a41;
if (res[2]!=0) res[2][14]=a50;
a55=a55*a57;
if (res[2]!=0) res[2][15]=a55;
a56=a56*a61;
if (res[2]!=0) res[2][16]=a56;
a52=a52*a42;
a45=a45*a51;
a52=a52-a45;
if (res[2]!=0) res[2][17]=a52;
if (res[2]!=0) res[2][18]=a54;
a05=a34*a05;
a10=a27*a10;
a01=a33*a01;
a10=a10+a01;
a10=a10*a03;
a05=a05+a10;
a00=a27*a00;
a06=a33*a06;
a00=a00-a06;
a00=a00*a07;
a05=a05+a00;
a62=a34*a62;
a05=a05+a62;
a33=a33*a09;
a05=a05+a33;
a19=a19*a12;
a05=a05+a19;
a34=a34*a27;
a65=a65-a34;
a65=a65*a17;
a05=a05+a65;
if (res[2]!=0) res[2][19]=a05;
a11=a11*a15;
a20=a20-a11;
if (res[3]!=0) res[3][0]=a20;
return 0;
}
/* asens1_nonlinear_rk45_step:(x0[7],z0[0],p[20],u,adj_xf[7],adj_zf[0],adj_qf[0])->(xf[7],zf[0],qf[0],adj_x0[7],adj_z0[0],adj_p[20],adj_u) */
static int casadi_f10(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_int j, k;
casadi_real *pv, **sres, *uv;
const casadi_real **sarg;
struct casadi_erk_data e;
struct casadi_erk_prob pe;
struct casadi_ivp_data d;
struct casadi_ivp_prob p;
/* Problem structure */
p.nx1 = 7;
p.nz1 = 0;
p.nq1 = 0;
p.np1 = 20;
p.nu1 = 1;
p.nfwd = 0;
p.nadj = 1;
p.n_stages = 7;
p.a = casadi_c0;
p.alpha = casadi_c1;
p.m = casadi_c2;
p.n_dense = 4;
p.m_dense = casadi_c3;
p.sp_jac[0] = 0;
p.sp_jac[1] = 0;
p.sp_jac[2] = 0;
p.sp_jac[3] = 0;
p.sp_jac[4] = 0;
p.sp_jac[5] = 0;
p.sp_jac[6] = 0;
p.sp_jac[7] = 0;
p.sp_jac[8] = 0;
p.tape_size = 124000;
p.step_size = 0.;
p.nx_err = 7;
p.nz_err = 0;
p.nq_err = 0;
p.abstol = 1.0000000000000000e-13;
p.reltol = 9.9999999999999994e-12;
p.order_err = 4;
p.m_err = casadi_c4;
p.safety = 9.0000000000000002e-01;
p.fac_min = 2.0000000000000001e-01;
p.fac_max = 6.;
p.h_min = 1.0000000000000000e-14;
p.h_max = 0.;
p.h_init = 0.;
p.max_num_steps = 1000000;
p.ne = 0;
casadi_ivp_setup(&p);
/* Work vectors */
sarg = arg + 7; sres = res + 7;
pv = w; w += 20;
uv = w; w += 1;
d.prob = &p;
casadi_ivp_set_work(&d, &arg, &res, &iw, &w);
/* Method */
pe.fsal = 1;
e.prob = &pe;
e.nom = 0;
/* Initial state, parameters */
casadi_copy(arg[0], 7, d.y);
casadi_copy(arg[1], 0, d.y+7);
casadi_clear(d.y+7, 0);
casadi_copy(arg[2], 20, pv);
/* Forward integration: a run of steps per control group, as RuntimeIntegrator::eval */
for (j = 0; j < 1; ++j) {
casadi_copy(arg[3] ? arg[3] + j*1 : 0, 1, uv);
casadi_ivp_reset(&d, j ? casadi_c5[casadi_s0[j]-1] : 0., uv, j == 0);
for (k = casadi_s0[j]; k < casadi_s0[j+1]; ++k) {
casadi_ivp_advance(&d, casadi_c5[k], casadi_c5[casadi_s0[j+1]-1], 1);
while (casadi_erk(&d, &e)) {
switch (d.task) {
case IVP_EVAL_RHS:
sarg[0] = &d.t_arg;
sarg[1] = d.y_arg;
sarg[2] = d.y_arg+7;
sarg[3] = pv;
sarg[4] = d.u_step;
sres[0] = d.res;
sres[1] = d.res+7;
sres[2] = d.res+7;
if (casadi_f11(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
break;
case IVP_EVAL_VJP:
sarg[0] = &d.t_arg;
sarg[1] = d.y_arg;
sarg[2] = d.y_arg+7;
sarg[3] = pv;
sarg[4] = d.u_step;
sarg[5] = 0;
sarg[6] = 0;
sarg[7] = 0;
sarg[8] = 0;
sarg[9] = d.w;
sarg[10] = d.w+7;
sarg[11] = d.w+7;
sarg[12] = 0;
sres[0] = d.vjp_x;
sres[1] = d.vjp_z;
sres[2] = d.vjp_p;
sres[3] = d.vjp_u;
if (casadi_f12(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
break;
case IVP_STEP_CONTROL:
casadi_ivp_control(&d);
break;
default: d.fail = 1;
}
}
if (d.status != IVP_SUCCESS) return 1;
if (res[0]) casadi_copy(d.y_out, 7, res[0] + k*7);
if (res[1]) casadi_copy(d.y_out+7, 0, res[1] + k*0);
if (res[2]) casadi_copy(d.y_out+7, 0, res[2] + k*0);
}
}
/* Discrete adjoint, output interval by output interval */
casadi_ivp_reset_backward(&d);
for (j = 0; j >= 0; --j) {
/* Control adjoints of this group only */
casadi_clear(d.adj_u, 1);
for (k = casadi_s0[j+1]-1; k >= casadi_s0[j]; --k) {
/* Impulse from the adjoint seeds at output time k */
casadi_copy(arg[4] ? arg[4] + k*7 : 0, 7, d.seed+0);
casadi_ivp_impulse(&d, casadi_c5[k]);
while (casadi_erk(&d, &e)) {
switch (d.task) {
case IVP_EVAL_RHS:
sarg[0] = &d.t_arg;
sarg[1] = d.y_arg;
sarg[2] = d.y_arg+7;
sarg[3] = pv;
sarg[4] = d.u_step;
sres[0] = d.res;
sres[1] = d.res+7;
sres[2] = d.res+7;
if (casadi_f11(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
break;
case IVP_EVAL_VJP:
sarg[0] = &d.t_arg;
sarg[1] = d.y_arg;
sarg[2] = d.y_arg+7;
sarg[3] = pv;
sarg[4] = d.u_step;
sarg[5] = 0;
sarg[6] = 0;
sarg[7] = 0;
sarg[8] = 0;
sarg[9] = d.w;
sarg[10] = d.w+7;
sarg[11] = d.w+7;
sarg[12] = 0;
sres[0] = d.vjp_x;
sres[1] = d.vjp_z;
sres[2] = d.vjp_p;
sres[3] = d.vjp_u;
if (casadi_f12(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
break;
case IVP_STEP_CONTROL:
casadi_ivp_control(&d);
break;
default: d.fail = 1;
}
}
if (d.status != IVP_SUCCESS) return 1;
casadi_ivp_retreat(&d, casadi_c5[k], k > 0 ? casadi_c5[k-1] : 0.);
while (casadi_erk(&d, &e)) {
switch (d.task) {
case IVP_EVAL_RHS:
sarg[0] = &d.t_arg;
sarg[1] = d.y_arg;
sarg[2] = d.y_arg+7;
sarg[3] = pv;
sarg[4] = d.u_step;
sres[0] = d.res;
sres[1] = d.res+7;
sres[2] = d.res+7;
if (casadi_f11(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
break;
case IVP_EVAL_VJP:
sarg[0] = &d.t_arg;
sarg[1] = d.y_arg;
sarg[2] = d.y_arg+7;
sarg[3] = pv;
sarg[4] = d.u_step;
sarg[5] = 0;
sarg[6] = 0;
sarg[7] = 0;
sarg[8] = 0;
sarg[9] = d.w;
sarg[10] = d.w+7;
sarg[11] = d.w+7;
sarg[12] = 0;
sres[0] = d.vjp_x;
sres[1] = d.vjp_z;
sres[2] = d.vjp_p;
sres[3] = d.vjp_u;
if (casadi_f12(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
break;
case IVP_STEP_CONTROL:
casadi_ivp_control(&d);
break;
default: d.fail = 1;
}
}
if (d.status != IVP_SUCCESS) return 1;
}
if (res[6]) casadi_copy(d.adj_u, 1, res[6] + j*1);
}
if (res[3]) casadi_copy(d.ry, 7, res[3]);
if (res[5]) casadi_copy(d.adj_p, 20, res[5]);
return 0;
}
/* adj1_nonlinear_rk45_step:(x0[7],z0[0],p[20],u,adj_xf[],adj_zf[],adj_qf[],out_xf[7x1,0nz],out_zf[0],out_qf[0],out_adj_x0[],out_adj_z0[],out_adj_p[],out_adj_u[],adj2_xf[7],adj2_zf[0],adj2_qf[0],adj2_adj_x0[],adj2_adj_z0[],adj2_adj_p[],adj2_adj_u[])->(adj2_x0[7],adj2_z0[0],adj2_p[20],adj2_u,adj2_adj_xf[],adj2_adj_zf[],adj2_adj_qf[]) */
static int casadi_f9(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real **res1=res+7, *w0=w+124398, *w2=w+124405, w3, *w4=w+124425, *w7=w+124432, *w8=w+124439, w9;
const casadi_real **arg1=arg+21, *wr2;
/* #0: @0 = input[0][0] */
casadi_copy(arg[0], 7, w0);
/* #1: @1 = 0x1 */
/* #2: @2 = input[2][0] */
wr2 = arg[2] ? arg[2] : casadi_zeros;
/* #3: @3 = input[3][0] */
w3 = arg[3] ? arg[3][0] : 0;
/* #4: @4 = input[14][0] */
casadi_copy(arg[14], 7, w4);
/* #5: @5 = 0x1 */
/* #6: @6 = 0x1 */
/* #7: {NULL, NULL, NULL, @7, NULL, @8, @9} = asens1_nonlinear_rk45_step(@0, @1, @2, @3, @4, @5, @6) */
arg1[0]=w0;
arg1[1]=0;
arg1[2]=wr2;
arg1[3]=&w3;
arg1[4]=w4;
arg1[5]=0;
arg1[6]=0;
res1[0]=0;
res1[1]=0;
res1[2]=0;
res1[3]=w7;
res1[4]=0;
res1[5]=w8;
res1[6]=&w9;
if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
/* #8: {NULL, @0} = vertsplit(@7) */
casadi_copy(w7, 7, w0);
/* #9: output[0][0] = @0 */
casadi_copy(w0, 7, res[0]);
/* #10: {NULL, @2} = vertsplit(@8) */
casadi_copy(w8, 20, w2);
/* #11: output[2][0] = @2 */
casadi_copy(w2, 20, res[2]);
/* #12: {NULL, @3} = vertsplit(@9) */
w3 = w9;
/* #13: output[3][0] = @3 */
if (res[3]) res[3][0] = w3;
return 0;
}
/* adj1_nonlinear_rk45:(x0[7],u,p[19],h,out_xf[7x1,0nz],adj_xf[7])->(adj_x0[7],adj_u,adj_p[19],adj_h) */
static int casadi_f8(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_int i;
casadi_real **res1=res+4, *rr, *w00=w+124461, *w02=w+124468, w03, *w04=w+124487, *w09=w+124507, *w12=w+124514, *w13=w+124521, w14;
const casadi_real **arg1=arg+6, *cs, *wr02;
/* #0: @0 = input[0][0] */
casadi_copy(arg[0], 7, w00);
/* #1: @1 = 0x1 */
/* #2: @2 = input[2][0] */
wr02 = arg[2] ? arg[2] : casadi_zeros;
/* #3: @3 = input[3][0] */
w03 = arg[3] ? arg[3][0] : 0;
/* #4: @4 = vertcat(@2, @3) */
rr=w04;
for (i=0, cs=wr02; i<19; ++i) *rr++ = *cs++;
*rr++ = w03;
/* #5: @3 = input[1][0] */
w03 = arg[1] ? arg[1][0] : 0;
/* #6: @5 = 0x0 */
/* #7: @6 = zeros(7x1,0nz) */
/* #8: @7 = 0x1 */
/* #9: @8 = 0x1 */
/* #10: @9 = input[5][0] */
casadi_copy(arg[5], 7, w09);
/* #11: @10 = 0x1 */
/* #12: @11 = 0x1 */
/* #13: {@12, NULL, @13, @14, NULL, NULL, NULL} = adj1_nonlinear_rk45_step(@0, @1, @4, @3, @5, @5, @5, @6, @7, @8, @5, @5, @5, @5, @9, @10, @11, @5, @5, @5, @5) */
arg1[0]=w00;
arg1[1]=0;
arg1[2]=w04;
arg1[3]=&w03;
arg1[4]=0;
arg1[5]=0;
arg1[6]=0;
arg1[7]=0;
arg1[8]=0;
arg1[9]=0;
arg1[10]=0;
arg1[11]=0;
arg1[12]=0;
arg1[13]=0;
arg1[14]=w09;
arg1[15]=0;
arg1[16]=0;
arg1[17]=0;
arg1[18]=0;
arg1[19]=0;
arg1[20]=0;
res1[0]=w12;
res1[1]=0;
res1[2]=w13;
res1[3]=&w14;
res1[4]=0;
res1[5]=0;
res1[6]=0;
if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
/* #14: output[0][0] = @12 */
casadi_copy(w12, 7, res[0]);
/* #15: output[1][0] = @14 */
if (res[1]) res[1][0] = w14;
/* #16: {@2, @14} = vertsplit(@13) */
casadi_copy(w13, 19, w02);
w14 = w13[19];
/* #17: output[2][0] = @2 */
casadi_copy(w02, 19, res[2]);
/* #18: output[3][0] = @14 */
if (res[3]) res[3][0] = w14;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_nonlinear_rk45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f8(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_nonlinear_rk45_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_nonlinear_rk45_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_nonlinear_rk45_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_nonlinear_rk45_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_nonlinear_rk45_n_in(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_int adj1_nonlinear_rk45_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real adj1_nonlinear_rk45_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_nonlinear_rk45_name_in(casadi_int i) {
switch (i) {
case 0: return "x0";
case 1: return "u";
case 2: return "p";
case 3: return "h";
case 4: return "out_xf";
case 5: return "adj_xf";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_nonlinear_rk45_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_x0";
case 1: return "adj_u";
case 2: return "adj_p";
case 3: return "adj_h";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_nonlinear_rk45_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s1;
case 1: return casadi_s2;
case 2: return casadi_s3;
case 3: return casadi_s2;
case 4: return casadi_s4;
case 5: return casadi_s1;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_nonlinear_rk45_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s1;
case 1: return casadi_s2;
case 2: return casadi_s3;
case 3: return casadi_s2;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_nonlinear_rk45_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 47;
if (sz_res) *sz_res = 23;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 124541;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_nonlinear_rk45_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 47*sizeof(const casadi_real*);
if (sz_res) *sz_res = 23*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 124541*sizeof(casadi_real);
return 0;
}
/* rhsF:(t[0],x[7],z[0],p[20],u)->(ode[7],alg[0],quad[0]) */
static int casadi_f17(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13;
a00=arg[3]? arg[3][19] : 0;
a01=arg[4]? arg[4][0] : 0;
a02=arg[3]? arg[3][16] : 0;
a03=arg[3]? arg[3][15] : 0;
a04=arg[3]? arg[3][14] : 0;
a05=arg[3]? arg[3][10] : 0;
a06=arg[3]? arg[3][11] : 0;
a07=arg[3]? arg[3][9] : 0;
a06=a06*a07;
a05=a05+a06;
a06=arg[3]? arg[3][2] : 0;
a08=arg[1]? arg[1][1] : 0;
a09=a06*a08;
a10=arg[1]? arg[1][0] : 0;
a09=a09+a10;
a05=a05*a09;
a09=arg[3]? arg[3][12] : 0;
a11=arg[3]? arg[3][13] : 0;
a11=a11*a07;
a09=a09+a11;
a11=arg[3]? arg[3][4] : 0;
a12=a09*a11;
a05=a05/a12;
a12=1.;
a13=arg[3]? arg[3][17] : 0;
a12=a12-a13;
a12=a05*a12;
a05=a04*a05;
a05=atan(a05);
a13=a13*a05;
a13=a13/a04;
a12=a12+a13;
a04=a04*a12;
a04=atan(a04);
a03=a03*a04;
a03=sin(a03);
a02=a02*a03;
a02=a02*a07;
a02=a02*a09;
a02=2.*a02;
a09=a01-a02;
a07=5.0000000000000000e-01;
a03=arg[3]? arg[3][6] : 0;
a07=a07*a03;
a03=arg[3]? arg[3][7] : 0;
a07=a07*a03;
a03=arg[3]? arg[3][3] : 0;
a04=a03*a08;
a04=a10-a04;
a04=a04/a11;
a04=atan(a04);
a07=a07*a04;
a12=arg[3]? arg[3][5] : 0;
a07=a07*a12;
a12=casadi_sq(a11);
a07=a07*a12;
a09=a09-a07;
a12=arg[3]? arg[3][8] : 0;
a12=a12*a04;
a09=a09-a12;
a04=arg[3]? arg[3][0] : 0;
a09=a09/a04;
a04=a08*a11;
a09=a09-a04;
a09=a00*a09;
if (res[0]!=0) res[0][0]=a09;
a07=a07*a03;
a01=a01*a03;
a02=a02*a06;
a01=a01+a02;
a07=a07-a01;
a12=a12*a03;
a07=a07+a12;
a12=arg[3]? arg[3][1] : 0;
a07=a07/a12;
a07=a00*a07;
if (res[0]!=0) res[0][1]=a07;
a07=a00*a10;
if (res[0]!=0) res[0][2]=a07;
a07=a00*a08;
if (res[0]!=0) res[0][3]=a07;
a07=arg[1]? arg[1][6] : 0;
a12=cos(a07);
a12=a11*a12;
a03=sin(a07);
a03=a10*a03;
a12=a12-a03;
a12=a00*a12;
if (res[0]!=0) res[0][4]=a12;
a12=sin(a07);
a11=a11*a12;
a07=cos(a07);
a10=a10*a07;
a11=a11+a10;
a11=a00*a11;
if (res[0]!=0) res[0][5]=a11;
a00=a00*a08;
if (res[0]!=0) res[0][6]=a00;
return 0;
}
/* fwd1_rhsF:(t[0],x[7],z[0],p[20],u,out_ode[7x1,0nz],out_alg[0],out_quad[0],fwd_t[0],fwd_x[7],fwd_z[0],fwd_p[20],fwd_u)->(fwd_ode[7],fwd_alg[0],fwd_quad[0]) */
static int casadi_f18(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55;
a00=arg[4]? arg[4][0] : 0;
a01=arg[3]? arg[3][16] : 0;
a02=arg[3]? arg[3][15] : 0;
a03=arg[3]? arg[3][14] : 0;
a04=arg[3]? arg[3][10] : 0;
a05=arg[3]? arg[3][11] : 0;
a06=arg[3]? arg[3][9] : 0;
a07=a05*a06;
a04=a04+a07;
a07=arg[3]? arg[3][2] : 0;
a08=arg[1]? arg[1][1] : 0;
a09=a07*a08;
a10=arg[1]? arg[1][0] : 0;
a09=a09+a10;
a11=a04*a09;
a12=arg[3]? arg[3][12] : 0;
a13=arg[3]? arg[3][13] : 0;
a14=a13*a06;
a12=a12+a14;
a14=arg[3]? arg[3][4] : 0;
a15=a12*a14;
a11=a11/a15;
a16=1.;
a17=arg[3]? arg[3][17] : 0;
a18=a16-a17;
a19=a11*a18;
a20=a03*a11;
a21=atan(a20);
a22=a17*a21;
a22=a22/a03;
a19=a19+a22;
a23=a03*a19;
a24=atan(a23);
a25=a02*a24;
a26=sin(a25);
a27=a01*a26;
a28=a27*a06;
a29=a28*a12;
a29=2.*a29;
a30=a00-a29;
a31=5.0000000000000000e-01;
a32=arg[3]? arg[3][6] : 0;
a32=a31*a32;
a33=arg[3]? arg[3][7] : 0;
a34=a32*a33;
a35=arg[3]? arg[3][3] : 0;
a36=a35*a08;
a36=a10-a36;
a36=a36/a14;
a37=atan(a36);
a38=a34*a37;
a39=arg[3]? arg[3][5] : 0;
a40=a38*a39;
a41=casadi_sq(a14);
a42=a40*a41;
a30=a30-a42;
a43=arg[3]? arg[3][8] : 0;
a44=a43*a37;
a30=a30-a44;
a45=arg[3]? arg[3][0] : 0;
a30=a30/a45;
a46=a08*a14;
a46=a30-a46;
a47=arg[11]? arg[11][19] : 0;
a46=a46*a47;
a48=arg[3]? arg[3][19] : 0;
a49=arg[12]? arg[12][0] : 0;
a50=arg[11]? arg[11][16] : 0;
a26=a26*a50;
a25=cos(a25);
a50=arg[11]? arg[11][15] : 0;
a24=a24*a50;
a50=arg[11]? arg[11][14] : 0;
a19=a19*a50;
a51=arg[11]? arg[11][10] : 0;
a52=arg[11]? arg[11][11] : 0;
a52=a06*a52;
a53=arg[11]? arg[11][9] : 0;
a05=a05*a53;
a52=a52+a05;
a51=a51+a52;
a09=a09*a51;
a51=arg[11]? arg[11][2] : 0;
a52=a08*a51;
a05=arg[9]? arg[9][1] : 0;
a54=a07*a05;
a52=a52+a54;
a54=arg[9]? arg[9][0] : 0;
a52=a52+a54;
a04=a04*a52;
a09=a09+a04;
a09=a09/a15;
a15=a11/a15;
a04=arg[11]? arg[11][12] : 0;
a52=arg[11]? arg[11][13] : 0;
a52=a06*a52;
a13=a13*a53;
a52=a52+a13;
a04=a04+a52;
a52=a14*a04;
a13=arg[11]? arg[11][4] : 0;
a55=a12*a13;
a52=a52+a55;
a15=a15*a52;
a09=a09-a15;
a18=a18*a09;
a15=arg[11]? arg[11][17] : 0;
a52=a11*a15;
a18=a18-a52;
a21=a21*a15;
a11=a11*a50;
a09=a03*a09;
a11=a11+a09;
a20=casadi_sq(a20);
a20=a16+a20;
a11=a11/a20;
a17=a17*a11;
a21=a21+a17;
a21=a21/a03;
a22=a22/a03;
a22=a22*a50;
a21=a21-a22;
a18=a18+a21;
a03=a03*a18;
a19=a19+a03;
a23=casadi_sq(a23);
a23=a16+a23;
a19=a19/a23;
a02=a02*a19;
a24=a24+a02;
a25=a25*a24;
a01=a01*a25;
a26=a26+a01;
a06=a06*a26;
a27=a27*a53;
a06=a06+a27;
a12=a12*a06;
a28=a28*a04;
a12=a12+a28;
a12=2.*a12;
a28=a49-a12;
a04=arg[11]? arg[11][6] : 0;
a31=a31*a04;
a33=a33*a31;
a31=arg[11]? arg[11][7] : 0;
a32=a32*a31;
a33=a33+a32;
a33=a37*a33;
a32=arg[11]? arg[11][3] : 0;
a31=a08*a32;
a04=a35*a05;
a31=a31+a04;
a31=a54-a31;
a31=a31/a14;
a04=a36/a14;
a04=a04*a13;
a31=a31-a04;
a36=casadi_sq(a36);
a16=a16+a36;
a31=a31/a16;
a34=a34*a31;
a33=a33+a34;
a39=a39*a33;
a33=arg[11]? arg[11][5] : 0;
a38=a38*a33;
a39=a39+a38;
a41=a41*a39;
a39=2.*a14;
a39=a39*a13;
a40=a40*a39;
a41=a41+a40;
a28=a28-a41;
a40=arg[11]? arg[11][8] : 0;
a37=a37*a40;
a43=a43*a31;
a37=a37+a43;
a28=a28-a37;
a28=a28/a45;
a30=a30/a45;
a45=arg[11]? arg[11][0] : 0;
a30=a30*a45;
a28=a28-a30;
a30=a14*a05;
a45=a08*a13;
a30=a30+a45;
a28=a28-a30;
a28=a48*a28;
a46=a46+a28;
if (res[0]!=0) res[0][0]=a46;
a46=a42*a35;
a28=a00*a35;
a30=a29*a07;
a28=a28+a30;
a46=a46-a28;
a28=a44*a35;
a46=a46+a28;
a28=arg[3]? arg[3][1] : 0;
a46=a46/a28;
a30=a46*a47;
a41=a35*a41;
a42=a42*a32;
a41=a41+a42;
a49=a35*a49;
a00=a00*a32;
a49=a49+a00;
a07=a07*a12;
a29=a29*a51;
a07=a07+a29;
a49=a49+a07;
a41=a41-a49;
a35=a35*a37;
a44=a44*a32;
a35=a35+a44;
a41=a41+a35;
a41=a41/a28;
a46=a46/a28;
a28=arg[11]? arg[11][1] : 0;
a46=a46*a28;
a41=a41-a46;
a41=a48*a41;
a30=a30+a41;
if (res[0]!=0) res[0][1]=a30;
a30=a10*a47;
a41=a48*a54;
a30=a30+a41;
if (res[0]!=0) res[0][2]=a30;
a30=a08*a47;
a41=a48*a05;
a30=a30+a41;
if (res[0]!=0) res[0][3]=a30;
a30=arg[1]? arg[1][6] : 0;
a41=cos(a30);
a46=a14*a41;
a28=sin(a30);
a35=a10*a28;
a46=a46-a35;
a46=a46*a47;
a41=a41*a13;
a35=sin(a30);
a44=arg[9]? arg[9][6] : 0;
a35=a35*a44;
a35=a14*a35;
a41=a41-a35;
a28=a28*a54;
a35=cos(a30);
a35=a35*a44;
a35=a10*a35;
a28=a28+a35;
a41=a41-a28;
a41=a48*a41;
a46=a46+a41;
if (res[0]!=0) res[0][4]=a46;
a46=sin(a30);
a41=a14*a46;
a28=cos(a30);
a35=a10*a28;
a41=a41+a35;
a41=a41*a47;
a46=a46*a13;
a13=cos(a30);
a13=a13*a44;
a14=a14*a13;
a46=a46+a14;
a28=a28*a54;
a30=sin(a30);
a30=a30*a44;
a10=a10*a30;
a28=a28-a10;
a46=a46+a28;
a46=a48*a46;
a41=a41+a46;
if (res[0]!=0) res[0][5]=a41;
a08=a08*a47;
a48=a48*a05;
a08=a08+a48;
if (res[0]!=0) res[0][6]=a08;
return 0;
}
/* vjpB:(t[0],x[7],z[0],p[20],u,out_ode[7x1,0nz],out_alg[0],out_quad[0],out_zero[0],adj_ode[7],adj_alg[0],adj_quad[0],adj_zero[0])->(adj_x[7],adj_z[0],adj_p[20],adj_u) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62, a63, a64, a65, a66, a67;
a00=arg[1]? arg[1][6] : 0;
a01=cos(a00);
a02=arg[3]? arg[3][19] : 0;
a03=arg[9]? arg[9][5] : 0;
a04=a02*a03;
a05=a01*a04;
a06=sin(a00);
a07=arg[9]? arg[9][4] : 0;
a08=a02*a07;
a09=a06*a08;
a05=a05-a09;
a09=arg[9]? arg[9][2] : 0;
a10=a02*a09;
a05=a05+a10;
a10=arg[3]? arg[3][8] : 0;
a11=arg[3]? arg[3][3] : 0;
a12=arg[9]? arg[9][1] : 0;
a13=a02*a12;
a14=arg[3]? arg[3][1] : 0;
a15=a13/a14;
a16=a11*a15;
a17=arg[9]? arg[9][0] : 0;
a18=a02*a17;
a19=arg[3]? arg[3][0] : 0;
a20=a18/a19;
a16=a16-a20;
a21=a10*a16;
a22=5.0000000000000000e-01;
a23=arg[3]? arg[3][6] : 0;
a23=a22*a23;
a24=arg[3]? arg[3][7] : 0;
a25=a23*a24;
a26=arg[3]? arg[3][5] : 0;
a27=arg[3]? arg[3][4] : 0;
a28=casadi_sq(a27);
a29=a11*a15;
a29=a29-a20;
a30=a28*a29;
a31=a26*a30;
a32=a25*a31;
a21=a21+a32;
a32=1.;
a33=arg[1]? arg[1][0] : 0;
a34=arg[1]? arg[1][1] : 0;
a35=a11*a34;
a35=a33-a35;
a35=a35/a27;
a36=casadi_sq(a35);
a36=a32+a36;
a21=a21/a36;
a36=a21/a27;
a05=a05+a36;
a37=arg[3]? arg[3][10] : 0;
a38=arg[3]? arg[3][11] : 0;
a39=arg[3]? arg[3][9] : 0;
a40=a38*a39;
a37=a37+a40;
a40=arg[3]? arg[3][14] : 0;
a41=arg[3]? arg[3][17] : 0;
a42=arg[3]? arg[3][15] : 0;
a43=arg[3]? arg[3][2] : 0;
a44=a43*a34;
a44=a44+a33;
a45=a37*a44;
a46=arg[3]? arg[3][12] : 0;
a47=arg[3]? arg[3][13] : 0;
a48=a47*a39;
a46=a46+a48;
a48=a46*a27;
a45=a45/a48;
a49=a32-a41;
a50=a45*a49;
a51=a40*a45;
a52=atan(a51);
a53=a41*a52;
a53=a53/a40;
a50=a50+a53;
a54=a40*a50;
a55=atan(a54);
a56=a42*a55;
a57=cos(a56);
a58=arg[3]? arg[3][16] : 0;
a59=a43*a15;
a59=a59+a20;
a59=-a59;
a59=2.*a59;
a60=a46*a59;
a61=a39*a60;
a62=a58*a61;
a57=a57*a62;
a42=a42*a57;
a54=casadi_sq(a54);
a54=a32+a54;
a42=a42/a54;
a41=a41*a42;
a51=casadi_sq(a51);
a32=a32+a51;
a41=a41/a32;
a32=a40*a41;
a51=a40*a42;
a49=a49*a51;
a32=a32+a49;
a49=a32/a48;
a37=a37*a49;
a05=a05+a37;
if (res[0]!=0) res[0][0]=a05;
a05=arg[9]? arg[9][6] : 0;
a54=a02*a05;
a62=arg[9]? arg[9][3] : 0;
a02=a02*a62;
a54=a54+a02;
a02=a27*a18;
a54=a54-a02;
a02=a11*a36;
a54=a54-a02;
a02=a43*a37;
a54=a54+a02;
if (res[0]!=0) res[0][1]=a54;
a54=0.;
if (res[0]!=0) res[0][2]=a54;
if (res[0]!=0) res[0][3]=a54;
if (res[0]!=0) res[0][4]=a54;
if (res[0]!=0) res[0][5]=a54;
a02=cos(a00);
a63=a27*a04;
a02=a02*a63;
a63=sin(a00);
a64=a33*a04;
a63=a63*a64;
a02=a02-a63;
a63=cos(a00);
a64=a33*a08;
a63=a63*a64;
a02=a02-a63;
a63=sin(a00);
a64=a27*a08;
a63=a63*a64;
a02=a02-a63;
if (res[0]!=0) res[0][6]=a02;
a02=arg[4]? arg[4][0] : 0;
a56=sin(a56);
a58=a58*a56;
a63=a58*a39;
a64=a63*a46;
a64=2.*a64;
a65=a02-a64;
a66=atan(a35);
a25=a25*a66;
a26=a25*a26;
a28=a26*a28;
a65=a65-a28;
a10=a10*a66;
a65=a65-a10;
a65=a65/a19;
a19=a65/a19;
a19=a19*a18;
a19=-a19;
if (res[2]!=0) res[2][0]=a19;
a19=a28*a11;
a67=a02*a11;
a43=a64*a43;
a67=a67+a43;
a19=a19-a67;
a67=a10*a11;
a19=a19+a67;
a19=a19/a14;
a14=a19/a14;
a14=a14*a13;
a14=-a14;
if (res[2]!=0) res[2][1]=a14;
a37=a34*a37;
a64=a64*a15;
a37=a37-a64;
if (res[2]!=0) res[2][2]=a37;
a10=a10*a15;
a02=a02*a15;
a10=a10-a02;
a28=a28*a15;
a10=a10+a28;
a36=a34*a36;
a10=a10-a36;
if (res[2]!=0) res[2][3]=a10;
a10=sin(a00);
a04=a10*a04;
a00=cos(a00);
a08=a00*a08;
a04=a04+a08;
a18=a34*a18;
a04=a04-a18;
a18=2.*a27;
a26=a26*a29;
a18=a18*a26;
a04=a04+a18;
a35=a35/a27;
a35=a35*a21;
a04=a04-a35;
a48=a45/a48;
a48=a48*a32;
a46=a46*a48;
a04=a04-a46;
if (res[2]!=0) res[2][4]=a04;
a25=a25*a30;
if (res[2]!=0) res[2][5]=a25;
a31=a66*a31;
a24=a24*a31;
a22=a22*a24;
if (res[2]!=0) res[2][6]=a22;
a23=a23*a31;
if (res[2]!=0) res[2][7]=a23;
a66=a66*a16;
if (res[2]!=0) res[2][8]=a66;
a58=a58*a60;
a63=a63*a59;
a48=a27*a48;
a63=a63-a48;
a47=a47*a63;
a58=a58+a47;
a44=a44*a49;
a38=a38*a44;
a58=a58+a38;
if (res[2]!=0) res[2][9]=a58;
if (res[2]!=0) res[2][10]=a44;
a44=a39*a44;
if (res[2]!=0) res[2][11]=a44;
if (res[2]!=0) res[2][12]=a63;
a39=a39*a63;
if (res[2]!=0) res[2][13]=a39;
a50=a50*a42;
a53=a53/a40;
a53=a53*a51;
a50=a50-a53;
a41=a45*a41;
a50=a50+a41;
if (res[2]!=0) res[2][14]=a50;
a55=a55*a57;
if (res[2]!=0) res[2][15]=a55;
a56=a56*a61;
if (res[2]!=0) res[2][16]=a56;
a52=a52*a42;
a45=a45*a51;
a52=a52-a45;
if (res[2]!=0) res[2][17]=a52;
if (res[2]!=0) res[2][18]=a54;
a05=a34*a05;
a10=a27*a10;
a01=a33*a01;
a10=a10+a01;
a10=a10*a03;
a05=a05+a10;
a00=a27*a00;
a06=a33*a06;
a00=a00-a06;
a00=a00*a07;
a05=a05+a00;
a62=a34*a62;
a05=a05+a62;
a33=a33*a09;
a05=a05+a33;
a19=a19*a12;
a05=a05+a19;
a34=a34*a27;
a65=a65-a34;
a65=a65*a17;
a05=a05+a65;
if (res[2]!=0) res[2][19]=a05;
a11=a11*a15;
a20=a20-a11;
if (res[3]!=0) res[3][0]=a20;
return 0;
}
/* fwd1_vjpB:(t[0],x[7],z[0],p[20],u,out_ode[7x1,0nz],out_alg[0],out_quad[0],out_zero[0],adj_ode[7],adj_alg[0],adj_quad[0],adj_zero[0],out_adj_x[7x1,0nz],out_adj_z[0],out_adj_p[20x1,0nz],out_adj_u[1x1,0nz],fwd_t[0],fwd_x[7],fwd_z[0],fwd_p[20],fwd_u,fwd_out_ode[7x1,0nz],fwd_out_alg[0],fwd_out_quad[0],fwd_out_zero[0],fwd_adj_ode[7],fwd_adj_alg[0],fwd_adj_quad[0],fwd_adj_zero[0])->(fwd_adj_x[7],fwd_adj_z[0],fwd_adj_p[20],fwd_adj_u) */
static int casadi_f20(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a000, a001, a002, a003, a004, a005, a006, a007, a008, a009, a010, a011;
casadi_real a012, a013, a014, a015, a016, a017, a018, a019, a020, a021, a022, a023;
casadi_real a024, a025, a026, a027, a028, a029, a030, a031, a032, a033, a034, a035;
casadi_real a036, a037, a038, a039, a040, a041, a042, a043, a044, a045, a046, a047;
casadi_real a048, a049, a050, a051, a052, a053, a054, a055, a056, a057, a058, a059;
casadi_real a060, a061, a062, a063, a064, a065, a066, a067, a068, a069, a070, a071;
casadi_real a072, a073, a074, a075, a076, a077, a078, a079, a080, a081, a082, a083;
casadi_real a084, a085, a086, a087, a088, a089, a090, a091, a092, a093, a094, a095;
casadi_real a096, a097, a098, a099, a100, a101, a102, a103, a104, a105, a106, a107;
casadi_real a108, a109, a110, a111, a112, a113, a114, a115, a116, a117, a118, a119;
casadi_real a120, a121, a122, a123, a124, a125, a126, a127, a128, a129, a130, a131;
casadi_real a132;
a000=arg[1]? arg[1][6] : 0;
a001=cos(a000);
a002=arg[9]? arg[9][5] : 0;
a003=arg[20]? arg[20][19] : 0;
a004=a002*a003;
a005=arg[3]? arg[3][19] : 0;
a006=arg[26]? arg[26][5] : 0;
a007=a005*a006;
a004=a004+a007;
a007=a001*a004;
a008=a005*a002;
a009=sin(a000);
a010=arg[18]? arg[18][6] : 0;
a009=a009*a010;
a011=a008*a009;
a007=a007-a011;
a011=arg[9]? arg[9][4] : 0;
a012=a005*a011;
a013=cos(a000);
a013=a013*a010;
a014=a012*a013;
a015=sin(a000);
a016=a011*a003;
a017=arg[26]? arg[26][4] : 0;
a018=a005*a017;
a016=a016+a018;
a018=a015*a016;
a014=a014+a018;
a007=a007-a014;
a014=arg[9]? arg[9][2] : 0;
a018=a014*a003;
a019=arg[26]? arg[26][2] : 0;
a020=a005*a019;
a018=a018+a020;
a007=a007+a018;
a018=arg[3]? arg[3][3] : 0;
a020=arg[9]? arg[9][1] : 0;
a021=a005*a020;
a022=arg[3]? arg[3][1] : 0;
a023=a021/a022;
a024=a018*a023;
a025=arg[9]? arg[9][0] : 0;
a026=a005*a025;
a027=arg[3]? arg[3][0] : 0;
a028=a026/a027;
a024=a024-a028;
a029=arg[20]? arg[20][8] : 0;
a030=a024*a029;
a031=arg[3]? arg[3][8] : 0;
a032=arg[20]? arg[20][3] : 0;
a033=a023*a032;
a034=a020*a003;
a035=arg[26]? arg[26][1] : 0;
a036=a005*a035;
a034=a034+a036;
a036=a034/a022;
a037=a023/a022;
a038=arg[20]? arg[20][1] : 0;
a037=a037*a038;
a036=a036-a037;
a037=a018*a036;
a033=a033+a037;
a037=a025*a003;
a039=arg[26]? arg[26][0] : 0;
a040=a005*a039;
a037=a037+a040;
a040=a037/a027;
a041=a028/a027;
a042=arg[20]? arg[20][0] : 0;
a041=a041*a042;
a040=a040-a041;
a033=a033-a040;
a041=a031*a033;
a030=a030+a041;
a041=arg[3]? arg[3][5] : 0;
a043=arg[3]? arg[3][4] : 0;
a044=casadi_sq(a043);
a045=a018*a023;
a045=a045-a028;
a046=a044*a045;
a047=a041*a046;
a048=arg[3]? arg[3][7] : 0;
a049=5.0000000000000000e-01;
a050=arg[20]? arg[20][6] : 0;
a050=a049*a050;
a051=a048*a050;
a052=arg[3]? arg[3][6] : 0;
a052=a049*a052;
a053=arg[20]? arg[20][7] : 0;
a054=a052*a053;
a051=a051+a054;
a054=a047*a051;
a055=a052*a048;
a056=arg[20]? arg[20][5] : 0;
a057=a046*a056;
a058=2.*a043;
a059=arg[20]? arg[20][4] : 0;
a058=a058*a059;
a060=a045*a058;
a061=a023*a032;
a062=a018*a036;
a061=a061+a062;
a061=a061-a040;
a062=a044*a061;
a060=a060+a062;
a062=a041*a060;
a057=a057+a062;
a062=a055*a057;
a054=a054+a062;
a030=a030+a054;
a054=1.;
a062=arg[1]? arg[1][0] : 0;
a063=arg[1]? arg[1][1] : 0;
a064=a018*a063;
a064=a062-a064;
a064=a064/a043;
a065=casadi_sq(a064);
a065=a054+a065;
a030=a030/a065;
a066=a031*a024;
a067=a055*a047;
a066=a066+a067;
a066=a066/a065;
a065=a066/a065;
a067=2.*a064;
a068=arg[18]? arg[18][0] : 0;
a069=a063*a032;
a070=arg[18]? arg[18][1] : 0;
a071=a018*a070;
a069=a069+a071;
a069=a068-a069;
a069=a069/a043;
a071=a064/a043;
a071=a071*a059;
a069=a069-a071;
a067=a067*a069;
a065=a065*a067;
a030=a030-a065;
a065=a030/a043;
a067=a066/a043;
a071=a067/a043;
a071=a071*a059;
a065=a065-a071;
a007=a007+a065;
a071=arg[3]? arg[3][14] : 0;
a072=arg[3]? arg[3][17] : 0;
a073=arg[3]? arg[3][15] : 0;
a074=arg[3]? arg[3][10] : 0;
a075=arg[3]? arg[3][11] : 0;
a076=arg[3]? arg[3][9] : 0;
a077=a075*a076;
a074=a074+a077;
a077=arg[3]? arg[3][2] : 0;
a078=a077*a063;
a078=a078+a062;
a079=a074*a078;
a080=arg[3]? arg[3][12] : 0;
a081=arg[3]? arg[3][13] : 0;
a082=a081*a076;
a080=a080+a082;
a082=a080*a043;
a079=a079/a082;
a083=a054-a072;
a084=a079*a083;
a085=a071*a079;
a086=atan(a085);
a087=a072*a086;
a087=a087/a071;
a084=a084+a087;
a088=a071*a084;
a089=atan(a088);
a090=a073*a089;
a091=cos(a090);
a092=arg[3]? arg[3][16] : 0;
a093=a077*a023;
a093=a093+a028;
a093=-a093;
a093=2.*a093;
a028=a080*a093;
a094=a076*a028;
a095=a092*a094;
a096=a091*a095;
a097=a073*a096;
a098=casadi_sq(a088);
a098=a054+a098;
a097=a097/a098;
a099=a072*a097;
a100=casadi_sq(a085);
a100=a054+a100;
a099=a099/a100;
a101=a071*a099;
a102=a071*a097;
a103=a083*a102;
a101=a101+a103;
a103=a101/a082;
a104=arg[20]? arg[20][10] : 0;
a105=arg[20]? arg[20][11] : 0;
a106=a076*a105;
a107=arg[20]? arg[20][9] : 0;
a108=a075*a107;
a106=a106+a108;
a104=a104+a106;
a106=a103*a104;
a108=arg[20]? arg[20][14] : 0;
a109=a099*a108;
a110=arg[20]? arg[20][17] : 0;
a111=a097*a110;
a112=arg[20]? arg[20][15] : 0;
a113=a096*a112;
a114=arg[20]? arg[20][16] : 0;
a115=a094*a114;
a116=a028*a107;
a117=arg[20]? arg[20][12] : 0;
a118=arg[20]? arg[20][13] : 0;
a119=a076*a118;
a120=a081*a107;
a119=a119+a120;
a117=a117+a119;
a119=a093*a117;
a120=arg[20]? arg[20][2] : 0;
a121=a023*a120;
a122=a077*a036;
a121=a121+a122;
a121=a121+a040;
a121=-a121;
a121=2.*a121;
a122=a080*a121;
a119=a119+a122;
a122=a076*a119;
a116=a116+a122;
a122=a092*a116;
a115=a115+a122;
a091=a091*a115;
a115=sin(a090);
a112=a089*a112;
a122=a084*a108;
a104=a078*a104;
a123=a063*a120;
a124=a077*a070;
a123=a123+a124;
a123=a123+a068;
a124=a074*a123;
a104=a104+a124;
a104=a104/a082;
a124=a079/a082;
a125=a043*a117;
a126=a080*a059;
a125=a125+a126;
a124=a124*a125;
a104=a104-a124;
a124=a083*a104;
a126=a079*a110;
a124=a124-a126;
a126=a086*a110;
a127=a079*a108;
a128=a071*a104;
a127=a127+a128;
a128=casadi_sq(a085);
a128=a054+a128;
a128=a127/a128;
a129=a072*a128;
a126=a126+a129;
a126=a126/a071;
a129=a087/a071;
a129=a129*a108;
a126=a126-a129;
a124=a124+a126;
a129=a071*a124;
a122=a122+a129;
a129=casadi_sq(a088);
a129=a054+a129;
a129=a122/a129;
a130=a073*a129;
a112=a112+a130;
a115=a115*a112;
a095=a095*a115;
a091=a091-a095;
a073=a073*a091;
a113=a113+a073;
a113=a113/a098;
a098=a097/a098;
a088=2.*a088;
a088=a088*a122;
a098=a098*a088;
a113=a113-a098;
a072=a072*a113;
a111=a111+a072;
a111=a111/a100;
a100=a099/a100;
a085=2.*a085;
a085=a085*a127;
a100=a100*a085;
a111=a111-a100;
a100=a071*a111;
a109=a109+a100;
a100=a097*a108;
a085=a071*a113;
a100=a100+a085;
a083=a083*a100;
a110=a102*a110;
a083=a083-a110;
a109=a109+a083;
a083=a109/a082;
a110=a103/a082;
a110=a110*a125;
a083=a083-a110;
a110=a074*a083;
a106=a106+a110;
a007=a007+a106;
if (res[0]!=0) res[0][0]=a007;
a007=arg[9]? arg[9][6] : 0;
a110=a007*a003;
a085=arg[26]? arg[26][6] : 0;
a127=a005*a085;
a110=a110+a127;
a127=arg[9]? arg[9][3] : 0;
a003=a127*a003;
a072=arg[26]? arg[26][3] : 0;
a005=a005*a072;
a003=a003+a005;
a110=a110+a003;
a003=a026*a059;
a005=a043*a037;
a003=a003+a005;
a110=a110-a003;
a003=a067*a032;
a005=a018*a065;
a003=a003+a005;
a110=a110-a003;
a074=a074*a103;
a003=a074*a120;
a005=a077*a106;
a003=a003+a005;
a110=a110+a003;
if (res[0]!=0) res[0][1]=a110;
a110=0.;
if (res[0]!=0) res[0][2]=a110;
if (res[0]!=0) res[0][3]=a110;
if (res[0]!=0) res[0][4]=a110;
if (res[0]!=0) res[0][5]=a110;
a003=cos(a000);
a005=a008*a059;
a098=a043*a004;
a005=a005+a098;
a003=a003*a005;
a005=a043*a008;
a098=sin(a000);
a098=a098*a010;
a005=a005*a098;
a003=a003-a005;
a005=a062*a008;
a098=cos(a000);
a098=a098*a010;
a005=a005*a098;
a098=sin(a000);
a088=a008*a068;
a122=a062*a004;
a088=a088+a122;
a098=a098*a088;
a005=a005+a098;
a003=a003-a005;
a005=cos(a000);
a098=a012*a068;
a088=a062*a016;
a098=a098+a088;
a005=a005*a098;
a098=a062*a012;
a088=sin(a000);
a088=a088*a010;
a098=a098*a088;
a005=a005-a098;
a003=a003-a005;
a005=a043*a012;
a098=cos(a000);
a098=a098*a010;
a005=a005*a098;
a098=sin(a000);
a088=a012*a059;
a122=a043*a016;
a088=a088+a122;
a098=a098*a088;
a005=a005+a098;
a003=a003-a005;
if (res[0]!=0) res[0][6]=a003;
a003=arg[21]? arg[21][0] : 0;
a005=sin(a090);
a114=a005*a114;
a090=cos(a090);
a090=a090*a112;
a112=a092*a090;
a114=a114+a112;
a112=a076*a114;
a092=a092*a005;
a098=a092*a107;
a112=a112+a098;
a098=a080*a112;
a088=a092*a076;
a122=a088*a117;
a098=a098+a122;
a098=2.*a098;
a122=a003-a098;
a073=atan(a064);
a051=a073*a051;
a095=casadi_sq(a064);
a054=a054+a095;
a054=a069/a054;
a095=a055*a054;
a051=a051+a095;
a095=a041*a051;
a055=a055*a073;
a056=a055*a056;
a095=a095+a056;
a056=a044*a095;
a041=a055*a041;
a058=a041*a058;
a056=a056+a058;
a122=a122-a056;
a029=a073*a029;
a058=a031*a054;
a029=a029+a058;
a122=a122-a029;
a122=a122/a027;
a058=arg[4]? arg[4][0] : 0;
a115=a088*a080;
a115=2.*a115;
a130=a058-a115;
a044=a041*a044;
a130=a130-a044;
a031=a031*a073;
a130=a130-a031;
a130=a130/a027;
a131=a130/a027;
a131=a131*a042;
a122=a122-a131;
a131=a122/a027;
a132=a130/a027;
a027=a132/a027;
a027=a027*a042;
a131=a131-a027;
a131=a026*a131;
a132=a132*a037;
a131=a131+a132;
a131=-a131;
if (res[2]!=0) res[2][0]=a131;
a131=a018*a056;
a132=a044*a032;
a131=a131+a132;
a132=a018*a003;
a027=a058*a032;
a132=a132+a027;
a027=a077*a098;
a120=a115*a120;
a027=a027+a120;
a132=a132+a027;
a131=a131-a132;
a132=a018*a029;
a027=a031*a032;
a132=a132+a027;
a131=a131+a132;
a131=a131/a022;
a132=a044*a018;
a027=a058*a018;
a077=a115*a077;
a027=a027+a077;
a132=a132-a027;
a027=a031*a018;
a132=a132+a027;
a132=a132/a022;
a027=a132/a022;
a027=a027*a038;
a131=a131-a027;
a027=a131/a022;
a077=a132/a022;
a022=a077/a022;
a022=a022*a038;
a027=a027-a022;
a021=a021*a027;
a077=a077*a034;
a021=a021+a077;
a021=-a021;
if (res[2]!=0) res[2][1]=a021;
a074=a074*a070;
a106=a063*a106;
a074=a074+a106;
a098=a023*a098;
a115=a115*a036;
a098=a098+a115;
a074=a074-a098;
if (res[2]!=0) res[2][2]=a074;
a029=a023*a029;
a031=a031*a036;
a029=a029+a031;
a003=a023*a003;
a058=a058*a036;
a003=a003+a058;
a029=a029-a003;
a056=a023*a056;
a044=a044*a036;
a056=a056+a044;
a029=a029+a056;
a067=a067*a070;
a065=a063*a065;
a067=a067+a065;
a029=a029-a067;
if (res[2]!=0) res[2][3]=a029;
a029=cos(a000);
a029=a029*a010;
a008=a008*a029;
a067=sin(a000);
a004=a067*a004;
a008=a008+a004;
a004=cos(a000);
a016=a004*a016;
a000=sin(a000);
a000=a000*a010;
a012=a012*a000;
a016=a016-a012;
a008=a008+a016;
a026=a026*a070;
a037=a063*a037;
a026=a026+a037;
a008=a008-a026;
a026=a041*a045;
a037=2.*a059;
a026=a026*a037;
a037=2.*a043;
a045=a045*a095;
a041=a041*a061;
a045=a045+a041;
a037=a037*a045;
a026=a026+a037;
a008=a008+a026;
a069=a069/a043;
a064=a064/a043;
a026=a064/a043;
a026=a026*a059;
a069=a069-a026;
a066=a066*a069;
a064=a064*a030;
a066=a066+a064;
a008=a008-a066;
a066=a079/a082;
a064=a066*a101;
a117=a064*a117;
a030=a104/a082;
a082=a066/a082;
a082=a082*a125;
a030=a030-a082;
a101=a101*a030;
a066=a066*a109;
a101=a101+a066;
a080=a080*a101;
a117=a117+a080;
a008=a008-a117;
if (res[2]!=0) res[2][4]=a008;
a046=a046*a051;
a055=a055*a060;
a046=a046+a055;
if (res[2]!=0) res[2][5]=a046;
a046=a073*a047;
a053=a046*a053;
a047=a047*a054;
a057=a073*a057;
a047=a047+a057;
a048=a048*a047;
a053=a053+a048;
a049=a049*a053;
if (res[2]!=0) res[2][6]=a049;
a046=a046*a050;
a052=a052*a047;
a046=a046+a052;
if (res[2]!=0) res[2][7]=a046;
a024=a024*a054;
a073=a073*a033;
a024=a024+a073;
if (res[2]!=0) res[2][8]=a024;
a028=a028*a114;
a092=a092*a119;
a028=a028+a092;
a092=a088*a093;
a119=a043*a064;
a092=a092-a119;
a118=a092*a118;
a093=a093*a112;
a088=a088*a121;
a093=a093+a088;
a064=a064*a059;
a101=a043*a101;
a064=a064+a101;
a093=a093-a064;
a081=a081*a093;
a118=a118+a081;
a028=a028+a118;
a118=a078*a103;
a105=a118*a105;
a103=a103*a123;
a078=a078*a083;
a103=a103+a078;
a075=a075*a103;
a105=a105+a075;
a028=a028+a105;
if (res[2]!=0) res[2][9]=a028;
if (res[2]!=0) res[2][10]=a103;
a118=a118*a107;
a103=a076*a103;
a118=a118+a103;
if (res[2]!=0) res[2][11]=a118;
if (res[2]!=0) res[2][12]=a093;
a092=a092*a107;
a076=a076*a093;
a092=a092+a076;
if (res[2]!=0) res[2][13]=a092;
a124=a097*a124;
a084=a084*a113;
a124=a124+a084;
a126=a126/a071;
a087=a087/a071;
a071=a087/a071;
a071=a071*a108;
a126=a126-a071;
a126=a102*a126;
a087=a087*a100;
a126=a126+a087;
a124=a124-a126;
a099=a099*a104;
a111=a079*a111;
a099=a099+a111;
a124=a124+a099;
if (res[2]!=0) res[2][14]=a124;
a096=a096*a129;
a089=a089*a091;
a096=a096+a089;
if (res[2]!=0) res[2][15]=a096;
a094=a094*a090;
a005=a005*a116;
a094=a094+a005;
if (res[2]!=0) res[2][16]=a094;
a097=a097*a128;
a086=a086*a113;
a097=a097+a086;
a102=a102*a104;
a079=a079*a100;
a102=a102+a079;
a097=a097-a102;
if (res[2]!=0) res[2][17]=a097;
if (res[2]!=0) res[2][18]=a110;
a007=a007*a070;
a085=a063*a085;
a007=a007+a085;
a085=a067*a059;
a029=a043*a029;
a085=a085+a029;
a029=a001*a068;
a009=a062*a009;
a029=a029-a009;
a085=a085+a029;
a002=a002*a085;
a067=a043*a067;
a001=a062*a001;
a067=a067+a001;
a067=a067*a006;
a002=a002+a067;
a007=a007+a002;
a002=a004*a059;
a000=a043*a000;
a002=a002-a000;
a000=a015*a068;
a013=a062*a013;
a000=a000+a013;
a002=a002-a000;
a011=a011*a002;
a004=a043*a004;
a015=a062*a015;
a004=a004-a015;
a004=a004*a017;
a011=a011+a004;
a007=a007+a011;
a127=a127*a070;
a072=a063*a072;
a127=a127+a072;
a007=a007+a127;
a014=a014*a068;
a062=a062*a019;
a014=a014+a062;
a007=a007+a014;
a020=a020*a131;
a132=a132*a035;
a020=a020+a132;
a007=a007+a020;
a070=a043*a070;
a059=a063*a059;
a070=a070+a059;
a122=a122-a070;
a025=a025*a122;
a063=a063*a043;
a130=a130-a063;
a130=a130*a039;
a025=a025+a130;
a007=a007+a025;
if (res[2]!=0) res[2][19]=a007;
a023=a023*a032;
a018=a018*a036;
a023=a023+a018;
a040=a040-a023;
if (res[3]!=0) res[3][0]=a040;
return 0;
}
/* fsens1_asens1_nonlinear_rk45_step:(x0[7x2],z0[0x2],p[20x2],u[1x2],adj_xf[7x2],adj_zf[0x2],adj_qf[0x2])->(xf[7x2],zf[0x2],qf[0x2],adj_x0[7x2],adj_z0[0x2],adj_p[20x2],adj_u[1x2]) */
static int casadi_f16(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_int j, k;
casadi_real *pv, **sres, *uv;
const casadi_real **sarg;
struct casadi_erk_data e;
struct casadi_erk_prob pe;
struct casadi_ivp_data d;
struct casadi_ivp_prob p;
/* Problem structure */
p.nx1 = 7;
p.nz1 = 0;
p.nq1 = 0;
p.np1 = 20;
p.nu1 = 1;
p.nfwd = 1;
p.nadj = 1;
p.n_stages = 7;
p.a = casadi_c0;
p.alpha = casadi_c1;
p.m = casadi_c2;
p.n_dense = 4;
p.m_dense = casadi_c3;
p.sp_jac[0] = 0;
p.sp_jac[1] = 0;
p.sp_jac[2] = 0;
p.sp_jac[3] = 0;
p.sp_jac[4] = 0;
p.sp_jac[5] = 0;
p.sp_jac[6] = 0;
p.sp_jac[7] = 0;
p.sp_jac[8] = 0;
p.tape_size = 238000;
p.step_size = 0.;
p.nx_err = 7;
p.nz_err = 0;
p.nq_err = 0;
p.abstol = 1.0000000000000000e-13;
p.reltol = 9.9999999999999994e-12;
p.order_err = 4;
p.m_err = casadi_c4;
p.safety = 9.0000000000000002e-01;
p.fac_min = 2.0000000000000001e-01;
p.fac_max = 6.;
p.h_min = 1.0000000000000000e-14;
p.h_max = 0.;
p.h_init = 0.;
p.max_num_steps = 1000000;
p.ne = 0;
casadi_ivp_setup(&p);
/* Work vectors */
sarg = arg + 7; sres = res + 7;
pv = w; w += 40;
uv = w; w += 2;
d.prob = &p;
casadi_ivp_set_work(&d, &arg, &res, &iw, &w);
/* Method */
pe.fsal = 1;
e.prob = &pe;
e.nom = 0;
/* Initial state, parameters */
casadi_copy(arg[0], 14, d.y);
casadi_copy(arg[1], 0, d.y+14);
casadi_clear(d.y+14, 0);
casadi_copy(arg[2], 40, pv);
/* Forward integration: a run of steps per control group, as RuntimeIntegrator::eval */
for (j = 0; j < 1; ++j) {
casadi_copy(arg[3] ? arg[3] + j*2 : 0, 2, uv);
casadi_ivp_reset(&d, j ? casadi_c5[casadi_s0[j]-1] : 0., uv, j == 0);
for (k = casadi_s0[j]; k < casadi_s0[j+1]; ++k) {
casadi_ivp_advance(&d, casadi_c5[k], casadi_c5[casadi_s0[j+1]-1], 1);
while (casadi_erk(&d, &e)) {
switch (d.task) {
case IVP_EVAL_RHS:
sarg[0] = &d.t_arg;
sarg[1] = d.y_arg;
sarg[2] = d.y_arg+14;
sarg[3] = pv;
sarg[4] = d.u_step;
sres[0] = d.res;
sres[1] = d.res+14;
sres[2] = d.res+14;
if (casadi_f17(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
sarg[5] = d.res;
sarg[6] = d.res+14;
sarg[7] = d.res+14;
sarg[8] = 0;
sarg[9] = d.y_arg+7;
sarg[10] = d.y_arg+14;
sarg[11] = pv+20;
sarg[12] = d.u_step+1;
sres[0] = d.res+7;
if (casadi_f18(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
break;
case IVP_EVAL_VJP:
sarg[0] = &d.t_arg;
sarg[1] = d.y_arg;
sarg[2] = d.y_arg+14;
sarg[3] = pv;
sarg[4] = d.u_step;
sarg[5] = 0;
sarg[6] = 0;
sarg[7] = 0;
sarg[8] = 0;
sarg[9] = d.w;
sarg[10] = d.w+14;
sarg[11] = d.w+14;
sarg[12] = 0;
sres[0] = d.vjp_x;
sres[1] = d.vjp_z;
sres[2] = d.vjp_p;
sres[3] = d.vjp_u;
if (casadi_f19(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
sarg[13] = d.vjp_x;
sarg[14] = d.vjp_z;
sarg[15] = d.vjp_p;
sarg[16] = d.vjp_u;
sarg[17] = 0;
sarg[18] = d.y_arg+7;
sarg[19] = d.y_arg+14;
sarg[20] = pv+20;
sarg[21] = d.u_step+1;
sarg[22] = 0;
sarg[23] = 0;
sarg[24] = 0;
sarg[25] = 0;
sarg[26] = d.w+7;
sarg[27] = d.w+14;
sarg[28] = d.w+14;
sarg[29] = 0;
sres[0] = d.vjp_x+7;
sres[2] = d.vjp_p+20;
sres[3] = d.vjp_u+1;
if (casadi_f20(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
break;
case IVP_STEP_CONTROL:
casadi_ivp_control(&d);
break;
default: d.fail = 1;
}
}
if (d.status != IVP_SUCCESS) return 1;
if (res[0]) casadi_copy(d.y_out, 14, res[0] + k*14);
if (res[1]) casadi_copy(d.y_out+14, 0, res[1] + k*0);
if (res[2]) casadi_copy(d.y_out+14, 0, res[2] + k*0);
}
}
/* Discrete adjoint, output interval by output interval */
casadi_ivp_reset_backward(&d);
for (j = 0; j >= 0; --j) {
/* Control adjoints of this group only */
casadi_clear(d.adj_u, 2);
for (k = casadi_s0[j+1]-1; k >= casadi_s0[j]; --k) {
/* Impulse from the adjoint seeds at output time k */
casadi_copy(arg[4] ? arg[4] + k*14 : 0, 14, d.seed+0);
casadi_ivp_impulse(&d, casadi_c5[k]);
while (casadi_erk(&d, &e)) {
switch (d.task) {
case IVP_EVAL_RHS:
sarg[0] = &d.t_arg;
sarg[1] = d.y_arg;
sarg[2] = d.y_arg+14;
sarg[3] = pv;
sarg[4] = d.u_step;
sres[0] = d.res;
sres[1] = d.res+14;
sres[2] = d.res+14;
if (casadi_f17(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
sarg[5] = d.res;
sarg[6] = d.res+14;
sarg[7] = d.res+14;
sarg[8] = 0;
sarg[9] = d.y_arg+7;
sarg[10] = d.y_arg+14;
sarg[11] = pv+20;
sarg[12] = d.u_step+1;
sres[0] = d.res+7;
if (casadi_f18(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
break;
case IVP_EVAL_VJP:
sarg[0] = &d.t_arg;
sarg[1] = d.y_arg;
sarg[2] = d.y_arg+14;
sarg[3] = pv;
sarg[4] = d.u_step;
sarg[5] = 0;
sarg[6] = 0;
sarg[7] = 0;
sarg[8] = 0;
sarg[9] = d.w;
sarg[10] = d.w+14;
sarg[11] = d.w+14;
sarg[12] = 0;
sres[0] = d.vjp_x;
sres[1] = d.vjp_z;
sres[2] = d.vjp_p;
sres[3] = d.vjp_u;
if (casadi_f19(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
sarg[13] = d.vjp_x;
sarg[14] = d.vjp_z;
sarg[15] = d.vjp_p;
sarg[16] = d.vjp_u;
sarg[17] = 0;
sarg[18] = d.y_arg+7;
sarg[19] = d.y_arg+14;
sarg[20] = pv+20;
sarg[21] = d.u_step+1;
sarg[22] = 0;
sarg[23] = 0;
sarg[24] = 0;
sarg[25] = 0;
sarg[26] = d.w+7;
sarg[27] = d.w+14;
sarg[28] = d.w+14;
sarg[29] = 0;
sres[0] = d.vjp_x+7;
sres[2] = d.vjp_p+20;
sres[3] = d.vjp_u+1;
if (casadi_f20(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
break;
case IVP_STEP_CONTROL:
casadi_ivp_control(&d);
break;
default: d.fail = 1;
}
}
if (d.status != IVP_SUCCESS) return 1;
casadi_ivp_retreat(&d, casadi_c5[k], k > 0 ? casadi_c5[k-1] : 0.);
while (casadi_erk(&d, &e)) {
switch (d.task) {
case IVP_EVAL_RHS:
sarg[0] = &d.t_arg;
sarg[1] = d.y_arg;
sarg[2] = d.y_arg+14;
sarg[3] = pv;
sarg[4] = d.u_step;
sres[0] = d.res;
sres[1] = d.res+14;
sres[2] = d.res+14;
if (casadi_f17(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
sarg[5] = d.res;
sarg[6] = d.res+14;
sarg[7] = d.res+14;
sarg[8] = 0;
sarg[9] = d.y_arg+7;
sarg[10] = d.y_arg+14;
sarg[11] = pv+20;
sarg[12] = d.u_step+1;
sres[0] = d.res+7;
if (casadi_f18(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
break;
case IVP_EVAL_VJP:
sarg[0] = &d.t_arg;
sarg[1] = d.y_arg;
sarg[2] = d.y_arg+14;
sarg[3] = pv;
sarg[4] = d.u_step;
sarg[5] = 0;
sarg[6] = 0;
sarg[7] = 0;
sarg[8] = 0;
sarg[9] = d.w;
sarg[10] = d.w+14;
sarg[11] = d.w+14;
sarg[12] = 0;
sres[0] = d.vjp_x;
sres[1] = d.vjp_z;
sres[2] = d.vjp_p;
sres[3] = d.vjp_u;
if (casadi_f19(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
sarg[13] = d.vjp_x;
sarg[14] = d.vjp_z;
sarg[15] = d.vjp_p;
sarg[16] = d.vjp_u;
sarg[17] = 0;
sarg[18] = d.y_arg+7;
sarg[19] = d.y_arg+14;
sarg[20] = pv+20;
sarg[21] = d.u_step+1;
sarg[22] = 0;
sarg[23] = 0;
sarg[24] = 0;
sarg[25] = 0;
sarg[26] = d.w+7;
sarg[27] = d.w+14;
sarg[28] = d.w+14;
sarg[29] = 0;
sres[0] = d.vjp_x+7;
sres[2] = d.vjp_p+20;
sres[3] = d.vjp_u+1;
if (casadi_f20(sarg, sres, iw, w, 0)) {
d.fail = 1;
break;
}
break;
case IVP_STEP_CONTROL:
casadi_ivp_control(&d);
break;
default: d.fail = 1;
}
}
if (d.status != IVP_SUCCESS) return 1;
}
if (res[6]) casadi_copy(d.adj_u, 2, res[6] + j*2);
}
if (res[3]) casadi_copy(d.ry, 14, res[3]);
if (res[5]) casadi_copy(d.adj_p, 40, res[5]);
return 0;
}
/* fwd1_asens1_nonlinear_rk45_step:(x0[7],z0[0],p[20],u,adj_xf[7],adj_zf[0],adj_qf[0],out_xf[7x1,0nz],out_zf[0],out_qf[0],out_adj_x0[7x1,0nz],out_adj_z0[0],out_adj_p[20x1,0nz],out_adj_u[1x1,0nz],fwd_x0[7],fwd_z0[0],fwd_p[20],fwd_u,fwd_adj_xf[7],fwd_adj_zf[0],fwd_adj_qf[0])->(fwd_xf[7],fwd_zf[0],fwd_qf[0],fwd_adj_x0[7],fwd_adj_z0[0],fwd_adj_p[20],fwd_adj_u) */
static int casadi_f15(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_int i;
casadi_real **res1=res+7, *rr, *w00=w+238786, *w01=w+238793, *w02=w+238800, *w04=w+238814, *w06=w+238834, w07, w08, *w09=w+238874, *w10=w+238876, *w13=w+238890;
casadi_real *w14=w+238904, *w15=w+238918, *w16=w+238958;
const casadi_real **arg1=arg+21, *cs, *wr04, *wr05;
/* #0: @0 = input[0][0] */
casadi_copy(arg[0], 7, w00);
/* #1: @1 = input[14][0] */
casadi_copy(arg[14], 7, w01);
/* #2: @2 = vertcat(@0, @1) */
rr=w02;
for (i=0, cs=w00; i<7; ++i) *rr++ = *cs++;
for (i=0, cs=w01; i<7; ++i) *rr++ = *cs++;
/* #3: @2 = reshape(@2) */
/* #4: @3 = 0x2 */
/* #5: @4 = input[2][0] */
wr04 = arg[2] ? arg[2] : casadi_zeros;
/* #6: @5 = input[16][0] */
wr05 = arg[16] ? arg[16] : casadi_zeros;
/* #7: @6 = vertcat(@4, @5) */
rr=w06;
for (i=0, cs=wr04; i<20; ++i) *rr++ = *cs++;
for (i=0, cs=wr05; i<20; ++i) *rr++ = *cs++;
/* #8: @6 = reshape(@6) */
/* #9: @7 = input[3][0] */
w07 = arg[3] ? arg[3][0] : 0;
/* #10: @8 = input[17][0] */
w08 = arg[17] ? arg[17][0] : 0;
/* #11: @9 = vertcat(@7, @8) */
rr=w09;
*rr++ = w07;
*rr++ = w08;
/* #12: @9 = @9' */
/* #13: @0 = input[4][0] */
casadi_copy(arg[4], 7, w00);
/* #14: @1 = input[18][0] */
casadi_copy(arg[18], 7, w01);
/* #15: @10 = vertcat(@0, @1) */
rr=w10;
for (i=0, cs=w00; i<7; ++i) *rr++ = *cs++;
for (i=0, cs=w01; i<7; ++i) *rr++ = *cs++;
/* #16: @10 = reshape(@10) */
/* #17: @11 = 0x2 */
/* #18: @12 = 0x2 */
/* #19: {@13, NULL, NULL, @14, NULL, @15, @16} = fsens1_asens1_nonlinear_rk45_step(@2, @3, @6, @9, @10, @11, @12) */
arg1[0]=w02;
arg1[1]=0;
arg1[2]=w06;
arg1[3]=w09;
arg1[4]=w10;
arg1[5]=0;
arg1[6]=0;
res1[0]=w13;
res1[1]=0;
res1[2]=0;
res1[3]=w14;
res1[4]=0;
res1[5]=w15;
res1[6]=w16;
if (casadi_f16(arg1, res1, iw, w, 0)) return 1;
/* #20: {NULL, @0} = horzsplit(@13) */
casadi_copy(w13+7, 7, w00);
/* #21: output[0][0] = @0 */
casadi_copy(w00, 7, res[0]);
/* #22: {NULL, @0} = horzsplit(@14) */
casadi_copy(w14+7, 7, w00);
/* #23: output[3][0] = @0 */
casadi_copy(w00, 7, res[3]);
/* #24: {NULL, @4} = horzsplit(@15) */
casadi_copy(w15+20, 20, w04);
/* #25: output[5][0] = @4 */
casadi_copy(w04, 20, res[5]);
/* #26: {NULL, @7} = horzsplit(@16) */
w07 = w16[1];
/* #27: output[6][0] = @7 */
if (res[6]) res[6][0] = w07;
return 0;
}
/* fwd1_adj1_nonlinear_rk45_step:(x0[7],z0[0],p[20],u,adj_xf[],adj_zf[],adj_qf[],out_xf[7x1,0nz],out_zf[0],out_qf[0],out_adj_x0[],out_adj_z0[],out_adj_p[],out_adj_u[],adj2_xf[7],adj2_zf[0],adj2_qf[0],adj2_adj_x0[],adj2_adj_z0[],adj2_adj_p[],adj2_adj_u[],out_adj2_x0[7x1,0nz],out_adj2_z0[0],out_adj2_p[20x1,0nz],out_adj2_u[1x1,0nz],out_adj2_adj_xf[],out_adj2_adj_zf[],out_adj2_adj_qf[],fwd_x0[7],fwd_z0[0],fwd_p[20],fwd_u,fwd_adj_xf[],fwd_adj_zf[],fwd_adj_qf[],fwd_out_xf[7x1,0nz],fwd_out_zf[0],fwd_out_qf[0],fwd_out_adj_x0[],fwd_out_adj_z0[],fwd_out_adj_p[],fwd_out_adj_u[],fwd_adj2_xf[7],fwd_adj2_zf[0],fwd_adj2_qf[0],fwd_adj2_adj_x0[],fwd_adj2_adj_z0[],fwd_adj2_adj_p[],fwd_adj2_adj_u[])->(fwd_adj2_x0[7],fwd_adj2_z0[0],fwd_adj2_p[20],fwd_adj2_u,fwd_adj2_adj_xf[],fwd_adj2_adj_zf[],fwd_adj2_adj_qf[]) */
static int casadi_f14(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real **res1=res+7, *w00=w+238982, *w02=w+238989, w03, *w04=w+239009, *w14=w+239016, w17, *w18=w+239023, *w21=w+239030, *w22=w+239037, w23;
const casadi_real **arg1=arg+49, *wr02, *wr16;
/* #0: @0 = input[0][0] */
casadi_copy(arg[0], 7, w00);
/* #1: @1 = 0x1 */
/* #2: @2 = input[2][0] */
wr02 = arg[2] ? arg[2] : casadi_zeros;
/* #3: @3 = input[3][0] */
w03 = arg[3] ? arg[3][0] : 0;
/* #4: @4 = input[14][0] */
casadi_copy(arg[14], 7, w04);
/* #5: @5 = 0x1 */
/* #6: @6 = 0x1 */
/* #7: @7 = zeros(7x1,0nz) */
/* #8: @8 = 0x1 */
/* #9: @9 = 0x1 */
/* #10: @10 = zeros(7x1,0nz) */
/* #11: @11 = 0x1 */
/* #12: @12 = zeros(20x1,0nz) */
/* #13: @13 = 00 */
/* #14: @14 = input[28][0] */
casadi_copy(arg[28], 7, w14);
/* #15: @15 = 0x1 */
/* #16: @16 = input[30][0] */
wr16 = arg[30] ? arg[30] : casadi_zeros;
/* #17: @17 = input[31][0] */
w17 = arg[31] ? arg[31][0] : 0;
/* #18: @18 = input[42][0] */
casadi_copy(arg[42], 7, w18);
/* #19: @19 = 0x1 */
/* #20: @20 = 0x1 */
/* #21: {NULL, NULL, NULL, @21, NULL, @22, @23} = fwd1_asens1_nonlinear_rk45_step(@0, @1, @2, @3, @4, @5, @6, @7, @8, @9, @10, @11, @12, @13, @14, @15, @16, @17, @18, @19, @20) */
arg1[0]=w00;
arg1[1]=0;
arg1[2]=wr02;
arg1[3]=&w03;
arg1[4]=w04;
arg1[5]=0;
arg1[6]=0;
arg1[7]=0;
arg1[8]=0;
arg1[9]=0;
arg1[10]=0;
arg1[11]=0;
arg1[12]=0;
arg1[13]=0;
arg1[14]=w14;
arg1[15]=0;
arg1[16]=wr16;
arg1[17]=&w17;
arg1[18]=w18;
arg1[19]=0;
arg1[20]=0;
res1[0]=0;
res1[1]=0;
res1[2]=0;
res1[3]=w21;
res1[4]=0;
res1[5]=w22;
res1[6]=&w23;
if (casadi_f15(arg1, res1, iw, w, 0)) return 1;
/* #22: {NULL, @0} = vertsplit(@21) */
casadi_copy(w21, 7, w00);
/* #23: output[0][0] = @0 */
casadi_copy(w00, 7, res[0]);
/* #24: {NULL, @2} = vertsplit(@22) */
casadi_copy(w22, 20, w02);
/* #25: output[2][0] = @2 */
casadi_copy(w02, 20, res[2]);
/* #26: {NULL, @3} = vertsplit(@23) */
w03 = w23;
/* #27: output[3][0] = @3 */
if (res[3]) res[3][0] = w03;
return 0;
}
/* fwd1_adj1_nonlinear_rk45:(x0[7],u,p[19],h,out_xf[7x1,0nz],adj_xf[7],out_adj_x0[7x1,0nz],out_adj_u[1x1,0nz],out_adj_p[19x1,0nz],out_adj_h[1x1,0nz],fwd_x0[7],fwd_u,fwd_p[19],fwd_h,fwd_out_xf[7x1,0nz],fwd_adj_xf[7])->(fwd_adj_x0[7],fwd_adj_u,fwd_adj_p[19],fwd_adj_h) */
static int casadi_f13(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_int i;
casadi_real **res1=res+4, *rr, *w00=w+239080, *w02=w+239087, w03, *w04=w+239106, *w09=w+239126, *w16=w+239133, w18, *w19=w+239140, *w23=w+239160, *w26=w+239167;
casadi_real *w27=w+239174, w28;
const casadi_real **arg1=arg+16, *cs, *wr02;
/* #0: @0 = input[0][0] */
casadi_copy(arg[0], 7, w00);
/* #1: @1 = 0x1 */
/* #2: @2 = input[2][0] */
wr02 = arg[2] ? arg[2] : casadi_zeros;
/* #3: @3 = input[3][0] */
w03 = arg[3] ? arg[3][0] : 0;
/* #4: @4 = vertcat(@2, @3) */
rr=w04;
for (i=0, cs=wr02; i<19; ++i) *rr++ = *cs++;
*rr++ = w03;
/* #5: @3 = input[1][0] */
w03 = arg[1] ? arg[1][0] : 0;
/* #6: @5 = 0x0 */
/* #7: @6 = zeros(7x1,0nz) */
/* #8: @7 = 0x1 */
/* #9: @8 = 0x1 */
/* #10: @9 = input[5][0] */
casadi_copy(arg[5], 7, w09);
/* #11: @10 = 0x1 */
/* #12: @11 = 0x1 */
/* #13: @12 = zeros(7x1,0nz) */
/* #14: @13 = 0x1 */
/* #15: @14 = zeros(20x1,0nz) */
/* #16: @15 = 00 */
/* #17: @16 = input[10][0] */
casadi_copy(arg[10], 7, w16);
/* #18: @17 = 0x1 */
/* #19: @2 = input[12][0] */
wr02 = arg[12] ? arg[12] : casadi_zeros;
/* #20: @18 = input[13][0] */
w18 = arg[13] ? arg[13][0] : 0;
/* #21: @19 = vertcat(@2, @18) */
rr=w19;
for (i=0, cs=wr02; i<19; ++i) *rr++ = *cs++;
*rr++ = w18;
/* #22: @18 = input[11][0] */
w18 = arg[11] ? arg[11][0] : 0;
/* #23: @20 = zeros(7x1,0nz) */
/* #24: @21 = 0x1 */
/* #25: @22 = 0x1 */
/* #26: @23 = input[15][0] */
casadi_copy(arg[15], 7, w23);
/* #27: @24 = 0x1 */
/* #28: @25 = 0x1 */
/* #29: {@26, NULL, @27, @28, NULL, NULL, NULL} = fwd1_adj1_nonlinear_rk45_step(@0, @1, @4, @3, @5, @5, @5, @6, @7, @8, @5, @5, @5, @5, @9, @10, @11, @5, @5, @5, @5, @12, @13, @14, @15, @5, @5, @5, @16, @17, @19, @18, @5, @5, @5, @20, @21, @22, @5, @5, @5, @5, @23, @24, @25, @5, @5, @5, @5) */
arg1[0]=w00;
arg1[1]=0;
arg1[2]=w04;
arg1[3]=&w03;
arg1[4]=0;
arg1[5]=0;
arg1[6]=0;
arg1[7]=0;
arg1[8]=0;
arg1[9]=0;
arg1[10]=0;
arg1[11]=0;
arg1[12]=0;
arg1[13]=0;
arg1[14]=w09;
arg1[15]=0;
arg1[16]=0;
arg1[17]=0;
arg1[18]=0;
arg1[19]=0;
arg1[20]=0;
arg1[21]=0;
arg1[22]=0;
arg1[23]=0;
arg1[24]=0;
arg1[25]=0;
arg1[26]=0;
arg1[27]=0;
arg1[28]=w16;
arg1[29]=0;
arg1[30]=w19;
arg1[31]=&w18;
arg1[32]=0;
arg1[33]=0;
arg1[34]=0;
arg1[35]=0;
arg1[36]=0;
arg1[37]=0;
arg1[38]=0;
arg1[39]=0;
arg1[40]=0;
arg1[41]=0;
arg1[42]=w23;
arg1[43]=0;
arg1[44]=0;
arg1[45]=0;
arg1[46]=0;
arg1[47]=0;
arg1[48]=0;
res1[0]=w26;
res1[1]=0;
res1[2]=w27;
res1[3]=&w28;
res1[4]=0;
res1[5]=0;
res1[6]=0;
if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
/* #30: output[0][0] = @26 */
casadi_copy(w26, 7, res[0]);
/* #31: output[1][0] = @28 */
if (res[1]) res[1][0] = w28;
/* #32: {@2, @28} = vertsplit(@27) */
casadi_copy(w27, 19, w02);
w28 = w27[19];
/* #33: output[2][0] = @2 */
casadi_copy(w02, 19, res[2]);
/* #34: output[3][0] = @28 */
if (res[3]) res[3][0] = w28;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_nonlinear_rk45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f13(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_nonlinear_rk45_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_nonlinear_rk45_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_nonlinear_rk45_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_nonlinear_rk45_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_nonlinear_rk45_n_in(void) { return 16;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_nonlinear_rk45_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_nonlinear_rk45_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_nonlinear_rk45_name_in(casadi_int i) {
switch (i) {
case 0: return "x0";
case 1: return "u";
case 2: return "p";
case 3: return "h";
case 4: return "out_xf";
case 5: return "adj_xf";
case 6: return "out_adj_x0";
case 7: return "out_adj_u";
case 8: return "out_adj_p";
case 9: return "out_adj_h";
case 10: return "fwd_x0";
case 11: return "fwd_u";
case 12: return "fwd_p";
case 13: return "fwd_h";
case 14: return "fwd_out_xf";
case 15: return "fwd_adj_xf";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_nonlinear_rk45_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_x0";
case 1: return "fwd_adj_u";
case 2: return "fwd_adj_p";
case 3: return "fwd_adj_h";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_nonlinear_rk45_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s1;
case 1: return casadi_s2;
case 2: return casadi_s3;
case 3: return casadi_s2;
case 4: return casadi_s4;
case 5: return casadi_s1;
case 6: return casadi_s4;
case 7: return casadi_s5;
case 8: return casadi_s6;
case 9: return casadi_s5;
case 10: return casadi_s1;
case 11: return casadi_s2;
case 12: return casadi_s3;
case 13: return casadi_s2;
case 14: return casadi_s4;
case 15: return casadi_s1;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_nonlinear_rk45_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s1;
case 1: return casadi_s2;
case 2: return casadi_s3;
case 3: return casadi_s2;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_nonlinear_rk45_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 123;
if (sz_res) *sz_res = 30;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 239194;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_nonlinear_rk45_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 123*sizeof(const casadi_real*);
if (sz_res) *sz_res = 30*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 239194*sizeof(casadi_real);
return 0;
}
