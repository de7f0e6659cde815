/* Generated from derive/ (digest bfd9ab80ef38709d) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
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
static const casadi_int casadi_s3[3] = {11, 1, 1};
static const casadi_int casadi_s4[4] = {7, 1, 0, 0};
static const casadi_int casadi_s5[4] = {1, 1, 0, 0};
static const casadi_int casadi_s6[4] = {11, 1, 0, 0};
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
static const casadi_real casadi_zeros[12] =
{0.};
/* rhsF:(t[0],x[7],z[0],p[12],u)->(ode[7],alg[0],quad[0]) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
a00=arg[3]? arg[3][11] : 0;
a01=arg[4]? arg[4][0] : 0;
a02=arg[3]? arg[3][8] : 0;
a03=arg[3]? arg[3][2] : 0;
a04=arg[1]? arg[1][1] : 0;
a05=a03*a04;
a06=arg[1]? arg[1][0] : 0;
a05=a05+a06;
a07=arg[3]? arg[3][4] : 0;
a05=a05/a07;
a02=a02*a05;
a02=2.*a02;
a05=a01-a02;
a08=5.0000000000000000e-01;
a09=arg[3]? arg[3][6] : 0;
a08=a08*a09;
a09=arg[3]? arg[3][7] : 0;
a08=a08*a09;
a09=arg[3]? arg[3][3] : 0;
a10=a09*a04;
a10=a06-a10;
a10=a10/a07;
a08=a08*a10;
a11=arg[3]? arg[3][5] : 0;
a08=a08*a11;
a11=casadi_sq(a07);
a08=a08*a11;
a05=a05-a08;
a11=arg[3]? arg[3][9] : 0;
a11=a11*a10;
a05=a05-a11;
a10=arg[3]? arg[3][0] : 0;
a05=a05/a10;
a10=a04*a07;
a05=a05-a10;
a05=a00*a05;
if (res[0]!=0) res[0][0]=a05;
a08=a08*a09;
a01=a01*a09;
a02=a02*a03;
a01=a01+a02;
a08=a08-a01;
a11=a11*a09;
a08=a08+a11;
a11=arg[3]? arg[3][1] : 0;
a08=a08/a11;
a08=a00*a08;
if (res[0]!=0) res[0][1]=a08;
a08=a00*a06;
if (res[0]!=0) res[0][2]=a08;
a08=a00*a04;
if (res[0]!=0) res[0][3]=a08;
a08=arg[1]? arg[1][6] : 0;
a11=cos(a08);
a11=a07*a11;
a09=sin(a08);
a09=a06*a09;
a11=a11-a09;
a11=a00*a11;
if (res[0]!=0) res[0][4]=a11;
a11=sin(a08);
a07=a07*a11;
a08=cos(a08);
a06=a06*a08;
a07=a07+a06;
a07=a00*a07;
if (res[0]!=0) res[0][5]=a07;
a00=a00*a04;
if (res[0]!=0) res[0][6]=a00;
return 0;
}
/* linear_rk45_step:(x0[7],z0[0],p[12],u,adj_xf[],adj_zf[],adj_qf[])->(xf[7],zf[0],qf[0],adj_x0[],adj_z0[],adj_p[],adj_u[]) */
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
p.np1 = 12;
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
pv = w; w += 12;
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
casadi_copy(arg[2], 12, pv);
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
/* linear_rk45:(x0[7],u,p[11],h)->(xf[7]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_int i;
casadi_real **res1=res+1, *rr, *w0=w+151, w3, *w4=w+158, *w6=w+170;
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
for (i=0, cs=wr2; i<11; ++i) *rr++ = *cs++;
*rr++ = w3;
/* #5: @3 = input[1][0] */
w3 = arg[1] ? arg[1][0] : 0;
/* #6: @5 = 0x0 */
/* #7: {@6, NULL, NULL, NULL, NULL, NULL, NULL} = linear_rk45_step(@0, @1, @4, @3, @5, @5, @5) */
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
CASADI_SYMBOL_EXPORT int linear_rk45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f0(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int linear_rk45_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void linear_rk45_release(int mem) {
}
CASADI_SYMBOL_EXPORT void linear_rk45_incref(void) {
}
CASADI_SYMBOL_EXPORT void linear_rk45_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int linear_rk45_n_in(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_int linear_rk45_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real linear_rk45_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* linear_rk45_name_in(casadi_int i) {
switch (i) {
case 0: return "x0";
case 1: return "u";
case 2: return "p";
case 3: return "h";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* linear_rk45_name_out(casadi_int i) {
switch (i) {
case 0: return "xf";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* linear_rk45_sparsity_in(casadi_int i) {
switch (i) {
case 0: return casadi_s1;
case 1: return casadi_s2;
case 2: return casadi_s3;
case 3: return casadi_s2;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* linear_rk45_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s1;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int linear_rk45_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 16;
if (sz_res) *sz_res = 12;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 177;
return 0;
}
CASADI_SYMBOL_EXPORT int linear_rk45_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
if (sz_res) *sz_res = 12*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 177*sizeof(casadi_real);
return 0;
}
/* rhsF:(t[0],x[7],z[0],p[12],u)->(ode[7],alg[0],quad[0]) */
static int casadi_f6(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
a00=arg[3]? arg[3][11] : 0;
a01=arg[4]? arg[4][0] : 0;
a02=arg[3]? arg[3][8] : 0;
a03=arg[3]? arg[3][2] : 0;
a04=arg[1]? arg[1][1] : 0;
a05=a03*a04;
a06=arg[1]? arg[1][0] : 0;
a05=a05+a06;
a07=arg[3]? arg[3][4] : 0;
a05=a05/a07;
a02=a02*a05;
a02=2.*a02;
a05=a01-a02;
a08=5.0000000000000000e-01;
a09=arg[3]? arg[3][6] : 0;
a08=a08*a09;
a09=arg[3]? arg[3][7] : 0;
a08=a08*a09;
a09=arg[3]? arg[3][3] : 0;
a10=a09*a04;
a10=a06-a10;
a10=a10/a07;
a08=a08*a10;
a11=arg[3]? arg[3][5] : 0;
a08=a08*a11;
a11=casadi_sq(a07);
a08=a08*a11;
a05=a05-a08;
a11=arg[3]? arg[3][9] : 0;
a11=a11*a10;
a05=a05-a11;
a10=arg[3]? arg[3][0] : 0;
a05=a05/a10;
a10=a04*a07;
a05=a05-a10;
a05=a00*a05;
if (res[0]!=0) res[0][0]=a05;
a08=a08*a09;
a01=a01*a09;
a02=a02*a03;
a01=a01+a02;
a08=a08-a01;
a11=a11*a09;
a08=a08+a11;
a11=arg[3]? arg[3][1] : 0;
a08=a08/a11;
a08=a00*a08;
if (res[0]!=0) res[0][1]=a08;
a08=a00*a06;
if (res[0]!=0) res[0][2]=a08;
a08=a00*a04;
if (res[0]!=0) res[0][3]=a08;
a08=arg[1]? arg[1][6] : 0;
a11=cos(a08);
a11=a07*a11;
a09=sin(a08);
a09=a06*a09;
a11=a11-a09;
a11=a00*a11;
if (res[0]!=0) res[0][4]=a11;
a11=sin(a08);
a07=a07*a11;
a08=cos(a08);
a06=a06*a08;
a07=a07+a06;
a07=a00*a07;
if (res[0]!=0) res[0][5]=a07;
a00=a00*a04;
if (res[0]!=0) res[0][6]=a00;
return 0;
}
/* fwd1_rhsF:(t[0],x[7],z[0],p[12],u,out_ode[7x1,0nz],out_alg[0],out_quad[0],fwd_t[0],fwd_x[7],fwd_z[0],fwd_p[12],fwd_u)->(fwd_ode[7],fwd_alg[0],fwd_quad[0]) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32;
a00=arg[4]? arg[4][0] : 0;
a01=arg[3]? arg[3][8] : 0;
a02=arg[3]? arg[3][2] : 0;
a03=arg[1]? arg[1][1] : 0;
a04=a02*a03;
a05=arg[1]? arg[1][0] : 0;
a04=a04+a05;
a06=arg[3]? arg[3][4] : 0;
a04=a04/a06;
a07=a01*a04;
a07=2.*a07;
a08=a00-a07;
a09=5.0000000000000000e-01;
a10=arg[3]? arg[3][6] : 0;
a10=a09*a10;
a11=arg[3]? arg[3][7] : 0;
a12=a10*a11;
a13=arg[3]? arg[3][3] : 0;
a14=a13*a03;
a14=a05-a14;
a14=a14/a06;
a15=a12*a14;
a16=arg[3]? arg[3][5] : 0;
a17=a15*a16;
a18=casadi_sq(a06);
a19=a17*a18;
a08=a08-a19;
a20=arg[3]? arg[3][9] : 0;
a21=a20*a14;
a08=a08-a21;
a22=arg[3]? arg[3][0] : 0;
a08=a08/a22;
a23=a03*a06;
a23=a08-a23;
a24=arg[11]? arg[11][11] : 0;
a23=a23*a24;
a25=arg[3]? arg[3][11] : 0;
a26=arg[12]? arg[12][0] : 0;
a27=arg[11]? arg[11][8] : 0;
a27=a04*a27;
a28=arg[11]? arg[11][2] : 0;
a29=a03*a28;
a30=arg[9]? arg[9][1] : 0;
a31=a02*a30;
a29=a29+a31;
a31=arg[9]? arg[9][0] : 0;
a29=a29+a31;
a29=a29/a06;
a04=a04/a06;
a32=arg[11]? arg[11][4] : 0;
a04=a04*a32;
a29=a29-a04;
a01=a01*a29;
a27=a27+a01;
a27=2.*a27;
a01=a26-a27;
a29=arg[11]? arg[11][6] : 0;
a09=a09*a29;
a11=a11*a09;
a09=arg[11]? arg[11][7] : 0;
a10=a10*a09;
a11=a11+a10;
a11=a14*a11;
a10=arg[11]? arg[11][3] : 0;
a09=a03*a10;
a29=a13*a30;
a09=a09+a29;
a09=a31-a09;
a09=a09/a06;
a29=a14/a06;
a29=a29*a32;
a09=a09-a29;
a12=a12*a09;
a11=a11+a12;
a16=a16*a11;
a11=arg[11]? arg[11][5] : 0;
a15=a15*a11;
a16=a16+a15;
a18=a18*a16;
a16=2.*a06;
a16=a16*a32;
a17=a17*a16;
a18=a18+a17;
a01=a01-a18;
a17=arg[11]? arg[11][9] : 0;
a14=a14*a17;
a20=a20*a09;
a14=a14+a20;
a01=a01-a14;
a01=a01/a22;
a08=a08/a22;
a22=arg[11]? arg[11][0] : 0;
a08=a08*a22;
a01=a01-a08;
a08=a06*a30;
a22=a03*a32;
a08=a08+a22;
a01=a01-a08;
a01=a25*a01;
a23=a23+a01;
if (res[0]!=0) res[0][0]=a23;
a23=a19*a13;
a01=a00*a13;
a08=a07*a02;
a01=a01+a08;
a23=a23-a01;
a01=a21*a13;
a23=a23+a01;
a01=arg[3]? arg[3][1] : 0;
a23=a23/a01;
a08=a23*a24;
a18=a13*a18;
a19=a19*a10;
a18=a18+a19;
a26=a13*a26;
a00=a00*a10;
a26=a26+a00;
a02=a02*a27;
a07=a07*a28;
a02=a02+a07;
a26=a26+a02;
a18=a18-a26;
a13=a13*a14;
a21=a21*a10;
a13=a13+a21;
a18=a18+a13;
a18=a18/a01;
a23=a23/a01;
a01=arg[11]? arg[11][1] : 0;
a23=a23*a01;
a18=a18-a23;
a18=a25*a18;
a08=a08+a18;
if (res[0]!=0) res[0][1]=a08;
a08=a05*a24;
a18=a25*a31;
a08=a08+a18;
if (res[0]!=0) res[0][2]=a08;
a08=a03*a24;
a18=a25*a30;
a08=a08+a18;
if (res[0]!=0) res[0][3]=a08;
a08=arg[1]? arg[1][6] : 0;
a18=cos(a08);
a23=a06*a18;
a01=sin(a08);
a13=a05*a01;
a23=a23-a13;
a23=a23*a24;
a18=a18*a32;
a13=sin(a08);
a21=arg[9]? arg[9][6] : 0;
a13=a13*a21;
a13=a06*a13;
a18=a18-a13;
a01=a01*a31;
a13=cos(a08);
a13=a13*a21;
a13=a05*a13;
a01=a01+a13;
a18=a18-a01;
a18=a25*a18;
a23=a23+a18;
if (res[0]!=0) res[0][4]=a23;
a23=sin(a08);
a18=a06*a23;
a01=cos(a08);
a13=a05*a01;
a18=a18+a13;
a18=a18*a24;
a23=a23*a32;
a32=cos(a08);
a32=a32*a21;
a06=a06*a32;
a23=a23+a06;
a01=a01*a31;
a08=sin(a08);
a08=a08*a21;
a05=a05*a08;
a01=a01-a05;
a23=a23+a01;
a23=a25*a23;
a18=a18+a23;
if (res[0]!=0) res[0][5]=a18;
a03=a03*a24;
a25=a25*a30;
a03=a03+a25;
if (res[0]!=0) res[0][6]=a03;
return 0;
}
/* fsens1_linear_rk45_step:(x0[7x2],z0[0x2],p[12x2],u[1x2],adj_xf[],adj_zf[],adj_qf[])->(xf[7x2],zf[0x2],qf[0x2],adj_x0[],adj_z0[],adj_p[],adj_u[]) */
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
p.np1 = 12;
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
pv = w; w += 24;
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
casadi_copy(arg[2], 24, pv);
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
sarg[11] = pv+12;
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
/* fwd1_linear_rk45_step:(x0[7],z0[0],p[12],u,adj_xf[],adj_zf[],adj_qf[],out_xf[7x1,0nz],out_zf[0],out_qf[0],out_adj_x0[],out_adj_z0[],out_adj_p[],out_adj_u[],fwd_x0[7],fwd_z0[0],fwd_p[12],fwd_u,fwd_adj_xf[],fwd_adj_zf[],fwd_adj_qf[])->(fwd_xf[7],fwd_zf[0],fwd_qf[0],fwd_adj_x0[],fwd_adj_z0[],fwd_adj_p[],fwd_adj_u[]) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_int i;
casadi_real **res1=res+7, *rr, *w00=w+304, *w01=w+311, *w02=w+318, *w06=w+332, w07, w08, *w09=w+356, *w13=w+358;
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
for (i=0, cs=wr04; i<12; ++i) *rr++ = *cs++;
for (i=0, cs=wr05; i<12; ++i) *rr++ = *cs++;
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
/* #16: {@13, NULL, NULL, NULL, NULL, NULL, NULL} = fsens1_linear_rk45_step(@2, @3, @6, @9, @10, @11, @12) */
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
/* fwd1_linear_rk45:(x0[7],u,p[11],h,out_xf[7x1,0nz],fwd_x0[7],fwd_u,fwd_p[11],fwd_h)->(fwd_xf[7]) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_int i;
casadi_real **res1=res+1, *rr, *w00=w+398, w03, *w04=w+405, *w09=w+417, w11, *w12=w+424, *w13=w+436;
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
for (i=0, cs=wr02; i<11; ++i) *rr++ = *cs++;
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
for (i=0, cs=wr02; i<11; ++i) *rr++ = *cs++;
*rr++ = w11;
/* #15: @11 = input[6][0] */
w11 = arg[6] ? arg[6][0] : 0;
/* #16: {@13, NULL, NULL, NULL, NULL, NULL, NULL} = fwd1_linear_rk45_step(@0, @1, @4, @3, @5, @5, @5, @6, @7, @8, @5, @5, @5, @5, @9, @10, @12, @11, @5, @5, @5) */
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
CASADI_SYMBOL_EXPORT int fwd1_linear_rk45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f3(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_linear_rk45_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_linear_rk45_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_linear_rk45_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_linear_rk45_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_linear_rk45_n_in(void) { return 9;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_linear_rk45_n_out(void) { return 1;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_linear_rk45_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_linear_rk45_name_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const char* fwd1_linear_rk45_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_xf";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_linear_rk45_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_linear_rk45_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s1;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_linear_rk45_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 50;
if (sz_res) *sz_res = 19;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 443;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_linear_rk45_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 50*sizeof(const casadi_real*);
if (sz_res) *sz_res = 19*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 443*sizeof(casadi_real);
return 0;
}
/* rhsF:(t[0],x[7],z[0],p[12],u)->(ode[7],alg[0],quad[0]) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
a00=arg[3]? arg[3][11] : 0;
a01=arg[4]? arg[4][0] : 0;
a02=arg[3]? arg[3][8] : 0;
a03=arg[3]? arg[3][2] : 0;
a04=arg[1]? arg[1][1] : 0;
a05=a03*a04;
a06=arg[1]? arg[1][0] : 0;
a05=a05+a06;
a07=arg[3]? arg[3][4] : 0;
a05=a05/a07;
a02=a02*a05;
a02=2.*a02;
a05=a01-a02;
a08=5.0000000000000000e-01;
a09=arg[3]? arg[3][6] : 0;
a08=a08*a09;
a09=arg[3]? arg[3][7] : 0;
a08=a08*a09;
a09=arg[3]? arg[3][3] : 0;
a10=a09*a04;
a10=a06-a10;
a10=a10/a07;
a08=a08*a10;
a11=arg[3]? arg[3][5] : 0;
a08=a08*a11;
a11=casadi_sq(a07);
a08=a08*a11;
a05=a05-a08;
a11=arg[3]? arg[3][9] : 0;
a11=a11*a10;
a05=a05-a11;
a10=arg[3]? arg[3][0] : 0;
a05=a05/a10;
a10=a04*a07;
a05=a05-a10;
a05=a00*a05;
if (res[0]!=0) res[0][0]=a05;
a08=a08*a09;
a01=a01*a09;
a02=a02*a03;
a01=a01+a02;
a08=a08-a01;
a11=a11*a09;
a08=a08+a11;
a11=arg[3]? arg[3][1] : 0;
a08=a08/a11;
a08=a00*a08;
if (res[0]!=0) res[0][1]=a08;
a08=a00*a06;
if (res[0]!=0) res[0][2]=a08;
a08=a00*a04;
if (res[0]!=0) res[0][3]=a08;
a08=arg[1]? arg[1][6] : 0;
a11=cos(a08);
a11=a07*a11;
a09=sin(a08);
a09=a06*a09;
a11=a11-a09;
a11=a00*a11;
if (res[0]!=0) res[0][4]=a11;
a11=sin(a08);
a07=a07*a11;
a08=cos(a08);
a06=a06*a08;
a07=a07+a06;
a07=a00*a07;
if (res[0]!=0) res[0][5]=a07;
a00=a00*a04;
if (res[0]!=0) res[0][6]=a00;
return 0;
}
/* vjpB:(t[0],x[7],z[0],p[12],u,out_ode[7x1,0nz],out_alg[0],out_quad[0],out_zero[0],adj_ode[7],adj_alg[0],adj_quad[0],adj_zero[0])->(adj_x[7],adj_z[0],adj_p[12],adj_u) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45;
a00=arg[1]? arg[1][6] : 0;
a01=cos(a00);
a02=arg[3]? arg[3][11] : 0;
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
a10=arg[3]? arg[3][9] : 0;
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
a32=a21/a27;
a05=a05+a32;
a33=arg[3]? arg[3][8] : 0;
a34=arg[3]? arg[3][2] : 0;
a35=a34*a15;
a35=a35+a20;
a35=-a35;
a35=2.*a35;
a36=a33*a35;
a37=a36/a27;
a05=a05+a37;
if (res[0]!=0) res[0][0]=a05;
a05=arg[9]? arg[9][6] : 0;
a38=a02*a05;
a39=arg[9]? arg[9][3] : 0;
a02=a02*a39;
a38=a38+a02;
a02=a27*a18;
a38=a38-a02;
a02=a11*a32;
a38=a38-a02;
a02=a34*a37;
a38=a38+a02;
if (res[0]!=0) res[0][1]=a38;
a38=0.;
if (res[0]!=0) res[0][2]=a38;
if (res[0]!=0) res[0][3]=a38;
if (res[0]!=0) res[0][4]=a38;
if (res[0]!=0) res[0][5]=a38;
a02=cos(a00);
a40=a27*a04;
a02=a02*a40;
a40=sin(a00);
a41=arg[1]? arg[1][0] : 0;
a42=a41*a04;
a40=a40*a42;
a02=a02-a40;
a40=cos(a00);
a42=a41*a08;
a40=a40*a42;
a02=a02-a40;
a40=sin(a00);
a42=a27*a08;
a40=a40*a42;
a02=a02-a40;
if (res[0]!=0) res[0][6]=a02;
a02=arg[4]? arg[4][0] : 0;
a40=arg[1]? arg[1][1] : 0;
a42=a34*a40;
a42=a42+a41;
a42=a42/a27;
a33=a33*a42;
a33=2.*a33;
a43=a02-a33;
a44=a11*a40;
a44=a41-a44;
a44=a44/a27;
a25=a25*a44;
a26=a25*a26;
a28=a26*a28;
a43=a43-a28;
a10=a10*a44;
a43=a43-a10;
a43=a43/a19;
a19=a43/a19;
a19=a19*a18;
a19=-a19;
if (res[2]!=0) res[2][0]=a19;
a19=a28*a11;
a45=a02*a11;
a34=a33*a34;
a45=a45+a34;
a19=a19-a45;
a45=a10*a11;
a19=a19+a45;
a19=a19/a14;
a14=a19/a14;
a14=a14*a13;
a14=-a14;
if (res[2]!=0) res[2][1]=a14;
a37=a40*a37;
a33=a33*a15;
a37=a37-a33;
if (res[2]!=0) res[2][2]=a37;
a10=a10*a15;
a02=a02*a15;
a10=a10-a02;
a28=a28*a15;
a10=a10+a28;
a32=a40*a32;
a10=a10-a32;
if (res[2]!=0) res[2][3]=a10;
a10=sin(a00);
a04=a10*a04;
a00=cos(a00);
a08=a00*a08;
a04=a04+a08;
a18=a40*a18;
a04=a04-a18;
a18=2.*a27;
a26=a26*a29;
a18=a18*a26;
a04=a04+a18;
a18=a44/a27;
a18=a18*a21;
a04=a04-a18;
a18=a42/a27;
a18=a18*a36;
a04=a04-a18;
if (res[2]!=0) res[2][4]=a04;
a25=a25*a30;
if (res[2]!=0) res[2][5]=a25;
a31=a44*a31;
a24=a24*a31;
a22=a22*a24;
if (res[2]!=0) res[2][6]=a22;
a23=a23*a31;
if (res[2]!=0) res[2][7]=a23;
a42=a42*a35;
if (res[2]!=0) res[2][8]=a42;
a44=a44*a16;
if (res[2]!=0) res[2][9]=a44;
if (res[2]!=0) res[2][10]=a38;
a05=a40*a05;
a10=a27*a10;
a01=a41*a01;
a10=a10+a01;
a10=a10*a03;
a05=a05+a10;
a00=a27*a00;
a06=a41*a06;
a00=a00-a06;
a00=a00*a07;
a05=a05+a00;
a39=a40*a39;
a05=a05+a39;
a41=a41*a09;
a05=a05+a41;
a19=a19*a12;
a05=a05+a19;
a40=a40*a27;
a43=a43-a40;
a43=a43*a17;
a05=a05+a43;
if (res[2]!=0) res[2][11]=a05;
a11=a11*a15;
a20=a20-a11;
if (res[3]!=0) res[3][0]=a20;
return 0;
}
/* asens1_linear_rk45_step:(x0[7],z0[0],p[12],u,adj_xf[7],adj_zf[0],adj_qf[0])->(xf[7],zf[0],qf[0],adj_x0[7],adj_z0[0],adj_p[12],adj_u) */
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
p.np1 = 12;
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
pv = w; w += 12;
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
casadi_copy(arg[2], 12, pv);
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
if (res[5]) casadi_copy(d.adj_p, 12, res[5]);
return 0;
}
/* adj1_linear_rk45_step:(x0[7],z0[0],p[12],u,adj_xf[],adj_zf[],adj_qf[],out_xf[7x1,0nz],out_zf[0],out_qf[0],out_adj_x0[],out_adj_z0[],out_adj_p[],out_adj_u[],adj2_xf[7],adj2_zf[0],adj2_qf[0],adj2_adj_x0[],adj2_adj_z0[],adj2_adj_p[],adj2_adj_u[])->(adj2_x0[7],adj2_z0[0],adj2_p[12],adj2_u,adj2_adj_xf[],adj2_adj_zf[],adj2_adj_qf[]) */
static int casadi_f9(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real **res1=res+7, *w0=w+124320, *w2=w+124327, w3, *w4=w+124339, *w7=w+124346, *w8=w+124353, w9;
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
/* #7: {NULL, NULL, NULL, @7, NULL, @8, @9} = asens1_linear_rk45_step(@0, @1, @2, @3, @4, @5, @6) */
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
casadi_copy(w8, 12, w2);
/* #11: output[2][0] = @2 */
casadi_copy(w2, 12, res[2]);
/* #12: {NULL, @3} = vertsplit(@9) */
w3 = w9;
/* #13: output[3][0] = @3 */
if (res[3]) res[3][0] = w3;
return 0;
}
/* adj1_linear_rk45:(x0[7],u,p[11],h,out_xf[7x1,0nz],adj_xf[7])->(adj_x0[7],adj_u,adj_p[11],adj_h) */
static int casadi_f8(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_int i;
casadi_real **res1=res+4, *rr, *w00=w+124367, *w02=w+124374, w03, *w04=w+124385, *w09=w+124397, *w12=w+124404, *w13=w+124411, w14;
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
for (i=0, cs=wr02; i<11; ++i) *rr++ = *cs++;
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
/* #13: {@12, NULL, @13, @14, NULL, NULL, NULL} = adj1_linear_rk45_step(@0, @1, @4, @3, @5, @5, @5, @6, @7, @8, @5, @5, @5, @5, @9, @10, @11, @5, @5, @5, @5) */
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
casadi_copy(w13, 11, w02);
w14 = w13[11];
/* #17: output[2][0] = @2 */
casadi_copy(w02, 11, res[2]);
/* #18: output[3][0] = @14 */
if (res[3]) res[3][0] = w14;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_linear_rk45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f8(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int adj1_linear_rk45_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void adj1_linear_rk45_release(int mem) {
}
CASADI_SYMBOL_EXPORT void adj1_linear_rk45_incref(void) {
}
CASADI_SYMBOL_EXPORT void adj1_linear_rk45_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int adj1_linear_rk45_n_in(void) { return 6;}
CASADI_SYMBOL_EXPORT casadi_int adj1_linear_rk45_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real adj1_linear_rk45_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* adj1_linear_rk45_name_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const char* adj1_linear_rk45_name_out(casadi_int i) {
switch (i) {
case 0: return "adj_x0";
case 1: return "adj_u";
case 2: return "adj_p";
case 3: return "adj_h";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* adj1_linear_rk45_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* adj1_linear_rk45_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s1;
case 1: return casadi_s2;
case 2: return casadi_s3;
case 3: return casadi_s2;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int adj1_linear_rk45_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 47;
if (sz_res) *sz_res = 23;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 124423;
return 0;
}
CASADI_SYMBOL_EXPORT int adj1_linear_rk45_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 47*sizeof(const casadi_real*);
if (sz_res) *sz_res = 23*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 124423*sizeof(casadi_real);
return 0;
}
/* rhsF:(t[0],x[7],z[0],p[12],u)->(ode[7],alg[0],quad[0]) */
static int casadi_f17(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
a00=arg[3]? arg[3][11] : 0;
a01=arg[4]? arg[4][0] : 0;
a02=arg[3]? arg[3][8] : 0;
a03=arg[3]? arg[3][2] : 0;
a04=arg[1]? arg[1][1] : 0;
a05=a03*a04;
a06=arg[1]? arg[1][0] : 0;
a05=a05+a06;
a07=arg[3]? arg[3][4] : 0;
a05=a05/a07;
a02=a02*a05;
a02=2.*a02;
a05=a01-a02;
a08=5.0000000000000000e-01;
a09=arg[3]? arg[3][6] : 0;
a08=a08*a09;
a09=arg[3]? arg[3][7] : 0;
a08=a08*a09;
a09=arg[3]? arg[3][3] : 0;
a10=a09*a04;
a10=a06-a10;
a10=a10/a07;
a08=a08*a10;
a11=arg[3]? arg[3][5] : 0;
a08=a08*a11;
a11=casadi_sq(a07);
a08=a08*a11;
a05=a05-a08;
a11=arg[3]? arg[3][9] : 0;
a11=a11*a10;
a05=a05-a11;
a10=arg[3]? arg[3][0] : 0;
a05=a05/a10;
a10=a04*a07;
a05=a05-a10;
a05=a00*a05;
if (res[0]!=0) res[0][0]=a05;
a08=a08*a09;
a01=a01*a09;
a02=a02*a03;
a01=a01+a02;
a08=a08-a01;
a11=a11*a09;
a08=a08+a11;
a11=arg[3]? arg[3][1] : 0;
a08=a08/a11;
a08=a00*a08;
if (res[0]!=0) res[0][1]=a08;
a08=a00*a06;
if (res[0]!=0) res[0][2]=a08;
a08=a00*a04;
if (res[0]!=0) res[0][3]=a08;
a08=arg[1]? arg[1][6] : 0;
a11=cos(a08);
a11=a07*a11;
a09=sin(a08);
a09=a06*a09;
a11=a11-a09;
a11=a00*a11;
if (res[0]!=0) res[0][4]=a11;
a11=sin(a08);
a07=a07*a11;
a08=cos(a08);
a06=a06*a08;
a07=a07+a06;
a07=a00*a07;
if (res[0]!=0) res[0][5]=a07;
a00=a00*a04;
if (res[0]!=0) res[0][6]=a00;
return 0;
}
/* fwd1_rhsF:(t[0],x[7],z[0],p[12],u,out_ode[7x1,0nz],out_alg[0],out_quad[0],fwd_t[0],fwd_x[7],fwd_z[0],fwd_p[12],fwd_u)->(fwd_ode[7],fwd_alg[0],fwd_quad[0]) */
static int casadi_f18(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32;
a00=arg[4]? arg[4][0] : 0;
a01=arg[3]? arg[3][8] : 0;
a02=arg[3]? arg[3][2] : 0;
a03=arg[1]? arg[1][1] : 0;
a04=a02*a03;
a05=arg[1]? arg[1][0] : 0;
a04=a04+a05;
a06=arg[3]? arg[3][4] : 0;
a04=a04/a06;
a07=a01*a04;
a07=2.*a07;
a08=a00-a07;
a09=5.0000000000000000e-01;
a10=arg[3]? arg[3][6] : 0;
a10=a09*a10;
a11=arg[3]? arg[3][7] : 0;
a12=a10*a11;
a13=arg[3]? arg[3][3] : 0;
a14=a13*a03;
a14=a05-a14;
a14=a14/a06;
a15=a12*a14;
a16=arg[3]? arg[3][5] : 0;
a17=a15*a16;
a18=casadi_sq(a06);
a19=a17*a18;
a08=a08-a19;
a20=arg[3]? arg[3][9] : 0;
a21=a20*a14;
a08=a08-a21;
a22=arg[3]? arg[3][0] : 0;
a08=a08/a22;
a23=a03*a06;
a23=a08-a23;
a24=arg[11]? arg[11][11] : 0;
a23=a23*a24;
a25=arg[3]? arg[3][11] : 0;
a26=arg[12]? arg[12][0] : 0;
a27=arg[11]? arg[11][8] : 0;
a27=a04*a27;
a28=arg[11]? arg[11][2] : 0;
a29=a03*a28;
a30=arg[9]? arg[9][1] : 0;
a31=a02*a30;
a29=a29+a31;
a31=arg[9]? arg[9][0] : 0;
a29=a29+a31;
a29=a29/a06;
a04=a04/a06;
a32=arg[11]? arg[11][4] : 0;
a04=a04*a32;
a29=a29-a04;
a01=a01*a29;
a27=a27+a01;
a27=2.*a27;
a01=a26-a27;
a29=arg[11]? arg[11][6] : 0;
a09=a09*a29;
a11=a11*a09;
a09=arg[11]? arg[11][7] : 0;
a10=a10*a09;
a11=a11+a10;
a11=a14*a11;
a10=arg[11]? arg[11][3] : 0;
a09=a03*a10;
a29=a13*a30;
a09=a09+a29;
a09=a31-a09;
a09=a09/a06;
a29=a14/a06;
a29=a29*a32;
a09=a09-a29;
a12=a12*a09;
a11=a11+a12;
a16=a16*a11;
a11=arg[11]? arg[11][5] : 0;
a15=a15*a11;
a16=a16+a15;
a18=a18*a16;
a16=2.*a06;
a16=a16*a32;
a17=a17*a16;
a18=a18+a17;
a01=a01-a18;
a17=arg[11]? arg[11][9] : 0;
a14=a14*a17;
a20=a20*a09;
a14=a14+a20;
a01=a01-a14;
a01=a01/a22;
a08=a08/a22;
a22=arg[11]? arg[11][0] : 0;
a08=a08*a22;
a01=a01-a08;
a08=a06*a30;
a22=a03*a32;
a08=a08+a22;
a01=a01-a08;
a01=a25*a01;
a23=a23+a01;
if (res[0]!=0) res[0][0]=a23;
a23=a19*a13;
a01=a00*a13;
a08=a07*a02;
a01=a01+a08;
a23=a23-a01;
a01=a21*a13;
a23=a23+a01;
a01=arg[3]? arg[3][1] : 0;
a23=a23/a01;
a08=a23*a24;
a18=a13*a18;
a19=a19*a10;
a18=a18+a19;
a26=a13*a26;
a00=a00*a10;
a26=a26+a00;
a02=a02*a27;
a07=a07*a28;
a02=a02+a07;
a26=a26+a02;
a18=a18-a26;
a13=a13*a14;
a21=a21*a10;
a13=a13+a21;
a18=a18+a13;
a18=a18/a01;
a23=a23/a01;
a01=arg[11]? arg[11][1] : 0;
a23=a23*a01;
a18=a18-a23;
a18=a25*a18;
a08=a08+a18;
if (res[0]!=0) res[0][1]=a08;
a08=a05*a24;
a18=a25*a31;
a08=a08+a18;
if (res[0]!=0) res[0][2]=a08;
a08=a03*a24;
a18=a25*a30;
a08=a08+a18;
if (res[0]!=0) res[0][3]=a08;
a08=arg[1]? arg[1][6] : 0;
a18=cos(a08);
a23=a06*a18;
a01=sin(a08);
a13=a05*a01;
a23=a23-a13;
a23=a23*a24;
a18=a18*a32;
a13=sin(a08);
a21=arg[9]? arg[9][6] : 0;
a13=a13*a21;
a13=a06*a13;
a18=a18-a13;
a01=a01*a31;
a13=cos(a08);
a13=a13*a21;
a13=a05*a13;
a01=a01+a13;
a18=a18-a01;
a18=a25*a18;
a23=a23+a18;
if (res[0]!=0) res[0][4]=a23;
a23=sin(a08);
a18=a06*a23;
a01=cos(a08);
a13=a05*a01;
a18=a18+a13;
a18=a18*a24;
a23=a23*a32;
a32=cos(a08);
a32=a32*a21;
a06=a06*a32;
a23=a23+a06;
a01=a01*a31;
a08=sin(a08);
a08=a08*a21;
a05=a05*a08;
a01=a01-a05;
a23=a23+a01;
a23=a25*a23;
a18=a18+a23;
if (res[0]!=0) res[0][5]=a18;
a03=a03*a24;
a25=a25*a30;
a03=a03+a25;
if (res[0]!=0) res[0][6]=a03;
return 0;
}
/* vjpB:(t[0],x[7],z[0],p[12],u,out_ode[7x1,0nz],out_alg[0],out_quad[0],out_zero[0],adj_ode[7],adj_alg[0],adj_quad[0],adj_zero[0])->(adj_x[7],adj_z[0],adj_p[12],adj_u) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45;
a00=arg[1]? arg[1][6] : 0;
a01=cos(a00);
a02=arg[3]? arg[3][11] : 0;
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
a10=arg[3]? arg[3][9] : 0;
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
a32=a21/a27;
a05=a05+a32;
a33=arg[3]? arg[3][8] : 0;
a34=arg[3]? arg[3][2] : 0;
a35=a34*a15;
a35=a35+a20;
a35=-a35;
a35=2.*a35;
a36=a33*a35;
a37=a36/a27;
a05=a05+a37;
if (res[0]!=0) res[0][0]=a05;
a05=arg[9]? arg[9][6] : 0;
a38=a02*a05;
a39=arg[9]? arg[9][3] : 0;
a02=a02*a39;
a38=a38+a02;
a02=a27*a18;
a38=a38-a02;
a02=a11*a32;
a38=a38-a02;
a02=a34*a37;
a38=a38+a02;
if (res[0]!=0) res[0][1]=a38;
a38=0.;
if (res[0]!=0) res[0][2]=a38;
if (res[0]!=0) res[0][3]=a38;
if (res[0]!=0) res[0][4]=a38;
if (res[0]!=0) res[0][5]=a38;
a02=cos(a00);
a40=a27*a04;
a02=a02*a40;
a40=sin(a00);
a41=arg[1]? arg[1][0] : 0;
a42=a41*a04;
a40=a40*a42;
a02=a02-a40;
a40=cos(a00);
a42=a41*a08;
a40=a40*a42;
a02=a02-a40;
a40=sin(a00);
a42=a27*a08;
a40=a40*a42;
a02=a02-a40;
if (res[0]!=0) res[0][6]=a02;
a02=arg[4]? arg[4][0] : 0;
a40=arg[1]? arg[1][1] : 0;
a42=a34*a40;
a42=a42+a41;
a42=a42/a27;
a33=a33*a42;
a33=2.*a33;
a43=a02-a33;
a44=a11*a40;
a44=a41-a44;
a44=a44/a27;
a25=a25*a44;
a26=a25*a26;
a28=a26*a28;
a43=a43-a28;
a10=a10*a44;
a43=a43-a10;
a43=a43/a19;
a19=a43/a19;
a19=a19*a18;
a19=-a19;
if (res[2]!=0) res[2][0]=a19;
a19=a28*a11;
a45=a02*a11;
a34=a33*a34;
a45=a45+a34;
a19=a19-a45;
a45=a10*a11;
a19=a19+a45;
a19=a19/a14;
a14=a19/a14;
a14=a14*a13;
a14=-a14;
if (res[2]!=0) res[2][1]=a14;
a37=a40*a37;
a33=a33*a15;
a37=a37-a33;
if (res[2]!=0) res[2][2]=a37;
a10=a10*a15;
a02=a02*a15;
a10=a10-a02;
a28=a28*a15;
a10=a10+a28;
a32=a40*a32;
a10=a10-a32;
if (res[2]!=0) res[2][3]=a10;
a10=sin(a00);
a04=a10*a04;
a00=cos(a00);
a08=a00*a08;
a04=a04+a08;
a18=a40*a18;
a04=a04-a18;
a18=2.*a27;
a26=a26*a29;
a18=a18*a26;
a04=a04+a18;
a18=a44/a27;
a18=a18*a21;
a04=a04-a18;
a18=a42/a27;
a18=a18*a36;
a04=a04-a18;
if (res[2]!=0) res[2][4]=a04;
a25=a25*a30;
if (res[2]!=0) res[2][5]=a25;
a31=a44*a31;
a24=a24*a31;
a22=a22*a24;
if (res[2]!=0) res[2][6]=a22;
a23=a23*a31;
if (res[2]!=0) res[2][7]=a23;
a42=a42*a35;
if (res[2]!=0) res[2][8]=a42;
a44=a44*a16;
if (res[2]!=0) res[2][9]=a44;
if (res[2]!=0) res[2][10]=a38;
a05=a40*a05;
a10=a27*a10;
a01=a41*a01;
a10=a10+a01;
a10=a10*a03;
a05=a05+a10;
a00=a27*a00;
a06=a41*a06;
a00=a00-a06;
a00=a00*a07;
a05=a05+a00;
a39=a40*a39;
a05=a05+a39;
a41=a41*a09;
a05=a05+a41;
a19=a19*a12;
a05=a05+a19;
a40=a40*a27;
a43=a43-a40;
a43=a43*a17;
a05=a05+a43;
if (res[2]!=0) res[2][11]=a05;
a11=a11*a15;
a20=a20-a11;
if (res[3]!=0) res[3][0]=a20;
return 0;
}
/* fwd1_vjpB:(t[0],x[7],z[0],p[12],u,out_ode[7x1,0nz],out_alg[0],out_quad[0],out_zero[0],adj_ode[7],adj_alg[0],adj_quad[0],adj_zero[0],out_adj_x[7x1,0nz],out_adj_z[0],out_adj_p[12x1,0nz],out_adj_u[1x1,0nz],fwd_t[0],fwd_x[7],fwd_z[0],fwd_p[12],fwd_u,fwd_out_ode[7x1,0nz],fwd_out_alg[0],fwd_out_quad[0],fwd_out_zero[0],fwd_adj_ode[7],fwd_adj_alg[0],fwd_adj_quad[0],fwd_adj_zero[0])->(fwd_adj_x[7],fwd_adj_z[0],fwd_adj_p[12],fwd_adj_u) */
static int casadi_f20(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
casadi_real a84, a85, a86, a87, a88;
a00=arg[1]? arg[1][6] : 0;
a01=cos(a00);
a02=arg[9]? arg[9][5] : 0;
a03=arg[20]? arg[20][11] : 0;
a04=a02*a03;
a05=arg[3]? arg[3][11] : 0;
a06=arg[26]? arg[26][5] : 0;
a07=a05*a06;
a04=a04+a07;
a07=a01*a04;
a08=a05*a02;
a09=sin(a00);
a10=arg[18]? arg[18][6] : 0;
a09=a09*a10;
a11=a08*a09;
a07=a07-a11;
a11=arg[9]? arg[9][4] : 0;
a12=a05*a11;
a13=cos(a00);
a13=a13*a10;
a14=a12*a13;
a15=sin(a00);
a16=a11*a03;
a17=arg[26]? arg[26][4] : 0;
a18=a05*a17;
a16=a16+a18;
a18=a15*a16;
a14=a14+a18;
a07=a07-a14;
a14=arg[9]? arg[9][2] : 0;
a18=a14*a03;
a19=arg[26]? arg[26][2] : 0;
a20=a05*a19;
a18=a18+a20;
a07=a07+a18;
a18=arg[3]? arg[3][3] : 0;
a20=arg[9]? arg[9][1] : 0;
a21=a05*a20;
a22=arg[3]? arg[3][1] : 0;
a23=a21/a22;
a24=a18*a23;
a25=arg[9]? arg[9][0] : 0;
a26=a05*a25;
a27=arg[3]? arg[3][0] : 0;
a28=a26/a27;
a24=a24-a28;
a29=arg[20]? arg[20][9] : 0;
a30=a24*a29;
a31=arg[3]? arg[3][9] : 0;
a32=arg[20]? arg[20][3] : 0;
a33=a23*a32;
a34=a20*a03;
a35=arg[26]? arg[26][1] : 0;
a36=a05*a35;
a34=a34+a36;
a36=a34/a22;
a37=a23/a22;
a38=arg[20]? arg[20][1] : 0;
a37=a37*a38;
a36=a36-a37;
a37=a18*a36;
a33=a33+a37;
a37=a25*a03;
a39=arg[26]? arg[26][0] : 0;
a40=a05*a39;
a37=a37+a40;
a40=a37/a27;
a41=a28/a27;
a42=arg[20]? arg[20][0] : 0;
a41=a41*a42;
a40=a40-a41;
a33=a33-a40;
a41=a31*a33;
a30=a30+a41;
a41=arg[3]? arg[3][5] : 0;
a43=arg[3]? arg[3][4] : 0;
a44=casadi_sq(a43);
a45=a18*a23;
a45=a45-a28;
a46=a44*a45;
a47=a41*a46;
a48=arg[3]? arg[3][7] : 0;
a49=5.0000000000000000e-01;
a50=arg[20]? arg[20][6] : 0;
a50=a49*a50;
a51=a48*a50;
a52=arg[3]? arg[3][6] : 0;
a52=a49*a52;
a53=arg[20]? arg[20][7] : 0;
a54=a52*a53;
a51=a51+a54;
a54=a47*a51;
a55=a52*a48;
a56=arg[20]? arg[20][5] : 0;
a57=a46*a56;
a58=2.*a43;
a59=arg[20]? arg[20][4] : 0;
a58=a58*a59;
a60=a45*a58;
a61=a23*a32;
a62=a18*a36;
a61=a61+a62;
a61=a61-a40;
a62=a44*a61;
a60=a60+a62;
a62=a41*a60;
a57=a57+a62;
a62=a55*a57;
a54=a54+a62;
a30=a30+a54;
a54=a30/a43;
a62=a31*a24;
a63=a55*a47;
a62=a62+a63;
a63=a62/a43;
a64=a63/a43;
a64=a64*a59;
a54=a54-a64;
a07=a07+a54;
a64=arg[3]? arg[3][2] : 0;
a65=a64*a23;
a65=a65+a28;
a65=-a65;
a65=2.*a65;
a28=arg[20]? arg[20][8] : 0;
a66=a65*a28;
a67=arg[3]? arg[3][8] : 0;
a68=arg[20]? arg[20][2] : 0;
a69=a23*a68;
a70=a64*a36;
a69=a69+a70;
a69=a69+a40;
a69=-a69;
a69=2.*a69;
a70=a67*a69;
a66=a66+a70;
a70=a66/a43;
a71=a67*a65;
a72=a71/a43;
a73=a72/a43;
a73=a73*a59;
a70=a70-a73;
a07=a07+a70;
if (res[0]!=0) res[0][0]=a07;
a07=arg[9]? arg[9][6] : 0;
a73=a07*a03;
a74=arg[26]? arg[26][6] : 0;
a75=a05*a74;
a73=a73+a75;
a75=arg[9]? arg[9][3] : 0;
a03=a75*a03;
a76=arg[26]? arg[26][3] : 0;
a05=a05*a76;
a03=a03+a05;
a73=a73+a03;
a03=a26*a59;
a05=a43*a37;
a03=a03+a05;
a73=a73-a03;
a03=a63*a32;
a05=a18*a54;
a03=a03+a05;
a73=a73-a03;
a03=a72*a68;
a05=a64*a70;
a03=a03+a05;
a73=a73+a03;
if (res[0]!=0) res[0][1]=a73;
a73=0.;
if (res[0]!=0) res[0][2]=a73;
if (res[0]!=0) res[0][3]=a73;
if (res[0]!=0) res[0][4]=a73;
if (res[0]!=0) res[0][5]=a73;
a03=cos(a00);
a05=a08*a59;
a77=a43*a04;
a05=a05+a77;
a03=a03*a05;
a05=a43*a08;
a77=sin(a00);
a77=a77*a10;
a05=a05*a77;
a03=a03-a05;
a05=arg[1]? arg[1][0] : 0;
a77=a05*a08;
a78=cos(a00);
a78=a78*a10;
a77=a77*a78;
a78=sin(a00);
a79=arg[18]? arg[18][0] : 0;
a80=a08*a79;
a81=a05*a04;
a80=a80+a81;
a78=a78*a80;
a77=a77+a78;
a03=a03-a77;
a77=cos(a00);
a78=a12*a79;
a80=a05*a16;
a78=a78+a80;
a77=a77*a78;
a78=a05*a12;
a80=sin(a00);
a80=a80*a10;
a78=a78*a80;
a77=a77-a78;
a03=a03-a77;
a77=a43*a12;
a78=cos(a00);
a78=a78*a10;
a77=a77*a78;
a78=sin(a00);
a80=a12*a59;
a81=a43*a16;
a80=a80+a81;
a78=a78*a80;
a77=a77+a78;
a03=a03-a77;
if (res[0]!=0) res[0][6]=a03;
a03=arg[21]? arg[21][0] : 0;
a77=arg[1]? arg[1][1] : 0;
a78=a64*a77;
a78=a78+a05;
a78=a78/a43;
a28=a78*a28;
a80=a77*a68;
a81=arg[18]? arg[18][1] : 0;
a82=a64*a81;
a80=a80+a82;
a80=a80+a79;
a80=a80/a43;
a82=a78/a43;
a82=a82*a59;
a80=a80-a82;
a82=a67*a80;
a28=a28+a82;
a28=2.*a28;
a82=a03-a28;
a83=a18*a77;
a83=a05-a83;
a83=a83/a43;
a51=a83*a51;
a84=a77*a32;
a85=a18*a81;
a84=a84+a85;
a84=a79-a84;
a84=a84/a43;
a85=a83/a43;
a85=a85*a59;
a84=a84-a85;
a85=a55*a84;
a51=a51+a85;
a85=a41*a51;
a55=a55*a83;
a56=a55*a56;
a85=a85+a56;
a56=a44*a85;
a41=a55*a41;
a58=a41*a58;
a56=a56+a58;
a82=a82-a56;
a29=a83*a29;
a58=a31*a84;
a29=a29+a58;
a82=a82-a29;
a82=a82/a27;
a58=arg[4]? arg[4][0] : 0;
a67=a67*a78;
a67=2.*a67;
a86=a58-a67;
a44=a41*a44;
a86=a86-a44;
a31=a31*a83;
a86=a86-a31;
a86=a86/a27;
a87=a86/a27;
a87=a87*a42;
a82=a82-a87;
a87=a82/a27;
a88=a86/a27;
a27=a88/a27;
a27=a27*a42;
a87=a87-a27;
a87=a26*a87;
a88=a88*a37;
a87=a87+a88;
a87=-a87;
if (res[2]!=0) res[2][0]=a87;
a87=a18*a56;
a88=a44*a32;
a87=a87+a88;
a88=a18*a03;
a27=a58*a32;
a88=a88+a27;
a27=a64*a28;
a68=a67*a68;
a27=a27+a68;
a88=a88+a27;
a87=a87-a88;
a88=a18*a29;
a27=a31*a32;
a88=a88+a27;
a87=a87+a88;
a87=a87/a22;
a88=a44*a18;
a27=a58*a18;
a64=a67*a64;
a27=a27+a64;
a88=a88-a27;
a27=a31*a18;
a88=a88+a27;
a88=a88/a22;
a27=a88/a22;
a27=a27*a38;
a87=a87-a27;
a27=a87/a22;
a64=a88/a22;
a22=a64/a22;
a22=a22*a38;
a27=a27-a22;
a21=a21*a27;
a64=a64*a34;
a21=a21+a64;
a21=-a21;
if (res[2]!=0) res[2][1]=a21;
a72=a72*a81;
a70=a77*a70;
a72=a72+a70;
a28=a23*a28;
a67=a67*a36;
a28=a28+a67;
a72=a72-a28;
if (res[2]!=0) res[2][2]=a72;
a29=a23*a29;
a31=a31*a36;
a29=a29+a31;
a03=a23*a03;
a58=a58*a36;
a03=a03+a58;
a29=a29-a03;
a56=a23*a56;
a44=a44*a36;
a56=a56+a44;
a29=a29+a56;
a63=a63*a81;
a54=a77*a54;
a63=a63+a54;
a29=a29-a63;
if (res[2]!=0) res[2][3]=a29;
a29=cos(a00);
a29=a29*a10;
a08=a08*a29;
a63=sin(a00);
a04=a63*a04;
a08=a08+a04;
a04=cos(a00);
a16=a04*a16;
a00=sin(a00);
a00=a00*a10;
a12=a12*a00;
a16=a16-a12;
a08=a08+a16;
a26=a26*a81;
a37=a77*a37;
a26=a26+a37;
a08=a08-a26;
a26=a41*a45;
a37=2.*a59;
a26=a26*a37;
a37=2.*a43;
a45=a45*a85;
a41=a41*a61;
a45=a45+a41;
a37=a37*a45;
a26=a26+a37;
a08=a08+a26;
a26=a84/a43;
a37=a83/a43;
a45=a37/a43;
a45=a45*a59;
a26=a26-a45;
a62=a62*a26;
a37=a37*a30;
a62=a62+a37;
a08=a08-a62;
a62=a80/a43;
a37=a78/a43;
a30=a37/a43;
a30=a30*a59;
a62=a62-a30;
a71=a71*a62;
a37=a37*a66;
a71=a71+a37;
a08=a08-a71;
if (res[2]!=0) res[2][4]=a08;
a46=a46*a51;
a55=a55*a60;
a46=a46+a55;
if (res[2]!=0) res[2][5]=a46;
a46=a83*a47;
a53=a46*a53;
a47=a47*a84;
a57=a83*a57;
a47=a47+a57;
a48=a48*a47;
a53=a53+a48;
a49=a49*a53;
if (res[2]!=0) res[2][6]=a49;
a46=a46*a50;
a52=a52*a47;
a46=a46+a52;
if (res[2]!=0) res[2][7]=a46;
a65=a65*a80;
a78=a78*a69;
a65=a65+a78;
if (res[2]!=0) res[2][8]=a65;
a24=a24*a84;
a83=a83*a33;
a24=a24+a83;
if (res[2]!=0) res[2][9]=a24;
if (res[2]!=0) res[2][10]=a73;
a07=a07*a81;
a74=a77*a74;
a07=a07+a74;
a74=a63*a59;
a29=a43*a29;
a74=a74+a29;
a29=a01*a79;
a09=a05*a09;
a29=a29-a09;
a74=a74+a29;
a02=a02*a74;
a63=a43*a63;
a01=a05*a01;
a63=a63+a01;
a63=a63*a06;
a02=a02+a63;
a07=a07+a02;
a02=a04*a59;
a00=a43*a00;
a02=a02-a00;
a00=a15*a79;
a13=a05*a13;
a00=a00+a13;
a02=a02-a00;
a11=a11*a02;
a04=a43*a04;
a15=a05*a15;
a04=a04-a15;
a04=a04*a17;
a11=a11+a04;
a07=a07+a11;
a75=a75*a81;
a76=a77*a76;
a75=a75+a76;
a07=a07+a75;
a14=a14*a79;
a05=a05*a19;
a14=a14+a05;
a07=a07+a14;
a20=a20*a87;
a88=a88*a35;
a20=a20+a88;
a07=a07+a20;
a81=a43*a81;
a59=a77*a59;
a81=a81+a59;
a82=a82-a81;
a25=a25*a82;
a77=a77*a43;
a86=a86-a77;
a86=a86*a39;
a25=a25+a86;
a07=a07+a25;
if (res[2]!=0) res[2][11]=a07;
a23=a23*a32;
a18=a18*a36;
a23=a23+a18;
a40=a40-a23;
if (res[3]!=0) res[3][0]=a40;
return 0;
}
/* fsens1_asens1_linear_rk45_step:(x0[7x2],z0[0x2],p[12x2],u[1x2],adj_xf[7x2],adj_zf[0x2],adj_qf[0x2])->(xf[7x2],zf[0x2],qf[0x2],adj_x0[7x2],adj_z0[0x2],adj_p[12x2],adj_u[1x2]) */
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
p.np1 = 12;
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
pv = w; w += 24;
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
casadi_copy(arg[2], 24, pv);
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
sarg[11] = pv+12;
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
sarg[20] = pv+12;
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
sres[2] = d.vjp_p+12;
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
sarg[11] = pv+12;
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
sarg[20] = pv+12;
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
sres[2] = d.vjp_p+12;
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
sarg[11] = pv+12;
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
sarg[20] = pv+12;
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
sres[2] = d.vjp_p+12;
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
if (res[5]) casadi_copy(d.adj_p, 24, res[5]);
return 0;
}
/* fwd1_asens1_linear_rk45_step:(x0[7],z0[0],p[12],u,adj_xf[7],adj_zf[0],adj_qf[0],out_xf[7x1,0nz],out_zf[0],out_qf[0],out_adj_x0[7x1,0nz],out_adj_z0[0],out_adj_p[12x1,0nz],out_adj_u[1x1,0nz],fwd_x0[7],fwd_z0[0],fwd_p[12],fwd_u,fwd_adj_xf[7],fwd_adj_zf[0],fwd_adj_qf[0])->(fwd_xf[7],fwd_zf[0],fwd_qf[0],fwd_adj_x0[7],fwd_adj_z0[0],fwd_adj_p[12],fwd_adj_u) */
static int casadi_f15(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_int i;
casadi_real **res1=res+7, *rr, *w00=w+238630, *w01=w+238637, *w02=w+238644, *w04=w+238658, *w06=w+238670, w07, w08, *w09=w+238694, *w10=w+238696, *w13=w+238710;
casadi_real *w14=w+238724, *w15=w+238738, *w16=w+238762;
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
for (i=0, cs=wr04; i<12; ++i) *rr++ = *cs++;
for (i=0, cs=wr05; i<12; ++i) *rr++ = *cs++;
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
/* #19: {@13, NULL, NULL, @14, NULL, @15, @16} = fsens1_asens1_linear_rk45_step(@2, @3, @6, @9, @10, @11, @12) */
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
casadi_copy(w15+12, 12, w04);
/* #25: output[5][0] = @4 */
casadi_copy(w04, 12, res[5]);
/* #26: {NULL, @7} = horzsplit(@16) */
w07 = w16[1];
/* #27: output[6][0] = @7 */
if (res[6]) res[6][0] = w07;
return 0;
}
/* fwd1_adj1_linear_rk45_step:(x0[7],z0[0],p[12],u,adj_xf[],adj_zf[],adj_qf[],out_xf[7x1,0nz],out_zf[0],out_qf[0],out_adj_x0[],out_adj_z0[],out_adj_p[],out_adj_u[],adj2_xf[7],adj2_zf[0],adj2_qf[0],adj2_adj_x0[],adj2_adj_z0[],adj2_adj_p[],adj2_adj_u[],out_adj2_x0[7x1,0nz],out_adj2_z0[0],out_adj2_p[12x1,0nz],out_adj2_u[1x1,0nz],out_adj2_adj_xf[],out_adj2_adj_zf[],out_adj2_adj_qf[],fwd_x0[7],fwd_z0[0],fwd_p[12],fwd_u,fwd_adj_xf[],fwd_adj_zf[],fwd_adj_qf[],fwd_out_xf[7x1,0nz],fwd_out_zf[0],fwd_out_qf[0],fwd_out_adj_x0[],fwd_out_adj_z0[],fwd_out_adj_p[],fwd_out_adj_u[],fwd_adj2_xf[7],fwd_adj2_zf[0],fwd_adj2_qf[0],fwd_adj2_adj_x0[],fwd_adj2_adj_z0[],fwd_adj2_adj_p[],fwd_adj2_adj_u[])->(fwd_adj2_x0[7],fwd_adj2_z0[0],fwd_adj2_p[12],fwd_adj2_u,fwd_adj2_adj_xf[],fwd_adj2_adj_zf[],fwd_adj2_adj_qf[]) */
static int casadi_f14(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_real **res1=res+7, *w00=w+238778, *w02=w+238785, w03, *w04=w+238797, *w14=w+238804, w17, *w18=w+238811, *w21=w+238818, *w22=w+238825, w23;
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
/* #12: @12 = zeros(12x1,0nz) */
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
/* #21: {NULL, NULL, NULL, @21, NULL, @22, @23} = fwd1_asens1_linear_rk45_step(@0, @1, @2, @3, @4, @5, @6, @7, @8, @9, @10, @11, @12, @13, @14, @15, @16, @17, @18, @19, @20) */
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
casadi_copy(w22, 12, w02);
/* #25: output[2][0] = @2 */
casadi_copy(w02, 12, res[2]);
/* #26: {NULL, @3} = vertsplit(@23) */
w03 = w23;
/* #27: output[3][0] = @3 */
if (res[3]) res[3][0] = w03;
return 0;
}
/* fwd1_adj1_linear_rk45:(x0[7],u,p[11],h,out_xf[7x1,0nz],adj_xf[7],out_adj_x0[7x1,0nz],out_adj_u[1x1,0nz],out_adj_p[11x1,0nz],out_adj_h[1x1,0nz],fwd_x0[7],fwd_u,fwd_p[11],fwd_h,fwd_out_xf[7x1,0nz],fwd_adj_xf[7])->(fwd_adj_x0[7],fwd_adj_u,fwd_adj_p[11],fwd_adj_h) */
static int casadi_f13(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
casadi_int i;
casadi_real **res1=res+4, *rr, *w00=w+238852, *w02=w+238859, w03, *w04=w+238870, *w09=w+238882, *w16=w+238889, w18, *w19=w+238896, *w23=w+238908, *w26=w+238915;
casadi_real *w27=w+238922, w28;
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
for (i=0, cs=wr02; i<11; ++i) *rr++ = *cs++;
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
/* #15: @14 = zeros(12x1,0nz) */
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
for (i=0, cs=wr02; i<11; ++i) *rr++ = *cs++;
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
/* #29: {@26, NULL, @27, @28, NULL, NULL, NULL} = fwd1_adj1_linear_rk45_step(@0, @1, @4, @3, @5, @5, @5, @6, @7, @8, @5, @5, @5, @5, @9, @10, @11, @5, @5, @5, @5, @12, @13, @14, @15, @5, @5, @5, @16, @17, @19, @18, @5, @5, @5, @20, @21, @22, @5, @5, @5, @5, @23, @24, @25, @5, @5, @5, @5) */
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
casadi_copy(w27, 11, w02);
w28 = w27[11];
/* #33: output[2][0] = @2 */
casadi_copy(w02, 11, res[2]);
/* #34: output[3][0] = @28 */
if (res[3]) res[3][0] = w28;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_rk45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
return casadi_f13(arg, res, iw, w, mem);
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_rk45_checkout(void) {
return 0;
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_linear_rk45_release(int mem) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_linear_rk45_incref(void) {
}
CASADI_SYMBOL_EXPORT void fwd1_adj1_linear_rk45_decref(void) {
}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_linear_rk45_n_in(void) { return 16;}
CASADI_SYMBOL_EXPORT casadi_int fwd1_adj1_linear_rk45_n_out(void) { return 4;}
CASADI_SYMBOL_EXPORT casadi_real fwd1_adj1_linear_rk45_default_in(casadi_int i) {
switch (i) {
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_linear_rk45_name_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const char* fwd1_adj1_linear_rk45_name_out(casadi_int i) {
switch (i) {
case 0: return "fwd_adj_x0";
case 1: return "fwd_adj_u";
case 2: return "fwd_adj_p";
case 3: return "fwd_adj_h";
default: return 0;
}
}
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_linear_rk45_sparsity_in(casadi_int i) {
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
CASADI_SYMBOL_EXPORT const casadi_int* fwd1_adj1_linear_rk45_sparsity_out(casadi_int i) {
switch (i) {
case 0: return casadi_s1;
case 1: return casadi_s2;
case 2: return casadi_s3;
case 3: return casadi_s2;
default: return 0;
}
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_rk45_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 123;
if (sz_res) *sz_res = 30;
if (sz_iw) *sz_iw = 0;
if (sz_w) *sz_w = 238934;
return 0;
}
CASADI_SYMBOL_EXPORT int fwd1_adj1_linear_rk45_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
if (sz_arg) *sz_arg = 123*sizeof(const casadi_real*);
if (sz_res) *sz_res = 30*sizeof(casadi_real*);
if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
if (sz_w) *sz_w = 238934*sizeof(casadi_real);
return 0;
}
