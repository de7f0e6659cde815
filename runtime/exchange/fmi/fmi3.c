/* The component in version 3.0 of FMI. */
#include "component.c"
#include "fmi3Functions.h"
#include "token.h"

#define C ((component *)instance)
#define STATUS(failure) ((failure) ? fmi3Error : fmi3OK)
#define UNUSED(name) (void)(name)

static void tell(component *c, const char *message)
{
    fmi3LogMessageCallback log;
    memcpy(&log, &c->logger, sizeof log); /* C knows no cast from an object to a function */
    if (log)
        log(c->environment, fmi3Error, "logStatusError", message);
}

const char *fmi3GetVersion(void) { return fmi3Version; }

fmi3Status fmi3SetDebugLogging(fmi3Instance instance, fmi3Boolean on, size_t count,
    const fmi3String categories[])
{
    UNUSED(instance), UNUSED(on), UNUSED(count), UNUSED(categories);
    return fmi3OK;
}

static component *instantiated(fmi3String name, fmi3String token, void *environment,
    fmi3LogMessageCallback log)
{
    component *c = created(name ? name : "", environment);
    if (!c)
        return NULL;
    memcpy(&c->logger, &log, sizeof log);
    c->tell = tell;
    if (!token || strcmp(token, TOKEN)) {
        failed(c, "the description belongs to another component: wrong instantiationToken", 0);
        removed(c);
        return NULL;
    }
    return c;
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String place,
    fmi3Boolean visible, fmi3Boolean logging, fmi3InstanceEnvironment environment,
    fmi3LogMessageCallback log)
{
    UNUSED(place), UNUSED(visible), UNUSED(logging);
    return instantiated(name, token, environment, log);
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String place,
    fmi3Boolean visible, fmi3Boolean logging, fmi3Boolean event_mode, fmi3Boolean early_return,
    const fmi3ValueReference intermediate[], size_t n_intermediate,
    fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
    fmi3IntermediateUpdateCallback update)
{
    UNUSED(place), UNUSED(visible), UNUSED(logging), UNUSED(event_mode), UNUSED(early_return);
    UNUSED(intermediate), UNUSED(n_intermediate), UNUSED(update);
    return instantiated(name, token, environment, log);
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token,
    fmi3String place, fmi3Boolean visible, fmi3Boolean logging,
    fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
    fmi3ClockUpdateCallback update, fmi3LockPreemptionCallback lock,
    fmi3UnlockPreemptionCallback unlock)
{
    UNUSED(name), UNUSED(token), UNUSED(place), UNUSED(visible), UNUSED(logging);
    UNUSED(environment), UNUSED(log), UNUSED(update), UNUSED(lock), UNUSED(unlock);
    return NULL;
}

void fmi3FreeInstance(fmi3Instance instance) { removed(C); }

fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean has_tolerance,
    fmi3Float64 tolerance, fmi3Float64 start, fmi3Boolean has_stop, fmi3Float64 stop)
{
    UNUSED(has_stop), UNUSED(stop);
    C->now.time = start;
    if (has_tolerance && tolerance > 0)
        C->tolerance = tolerance;
    return fmi3OK;
}

fmi3Status fmi3Reset(fmi3Instance instance)
{
    reset(C);
    return fmi3OK;
}

#define NOTHING(name) \
    fmi3Status name(fmi3Instance instance) \
    { \
        UNUSED(instance); \
        return fmi3OK; \
    }
NOTHING(fmi3ExitInitializationMode)
NOTHING(fmi3EnterEventMode)
NOTHING(fmi3Terminate)
NOTHING(fmi3EnterConfigurationMode)
NOTHING(fmi3ExitConfigurationMode)
NOTHING(fmi3EvaluateDiscreteStates)
NOTHING(fmi3EnterContinuousTimeMode)
NOTHING(fmi3EnterStepMode)

/* --- Values --- */

fmi3Status fmi3GetFloat64(fmi3Instance instance, const fmi3ValueReference references[],
    size_t count, fmi3Float64 values[], size_t n_values)
{
    UNUSED(n_values);
    return STATUS(get(C, references, count, values));
}

fmi3Status fmi3SetFloat64(fmi3Instance instance, const fmi3ValueReference references[],
    size_t count, const fmi3Float64 values[], size_t n_values)
{
    UNUSED(n_values);
    return STATUS(set(C, references, count, values));
}

/* Of other types there is no variable. */
#define MISSING(what) STATUS(count && failed(C, "there are no " what, 0))
#define REFERENCES fmi3Instance instance, const fmi3ValueReference references[], size_t count
#define NO_VARIABLES(type) \
    fmi3Status fmi3Get##type(REFERENCES, fmi3##type values[], size_t n_values) \
    { \
        UNUSED(references), UNUSED(values), UNUSED(n_values); \
        return MISSING("variables of the type " #type); \
    } \
    fmi3Status fmi3Set##type(REFERENCES, const fmi3##type values[], size_t n_values) \
    { \
        UNUSED(references), UNUSED(values), UNUSED(n_values); \
        return MISSING("variables of the type " #type); \
    }
NO_VARIABLES(Float32)
NO_VARIABLES(Int8)
NO_VARIABLES(UInt8)
NO_VARIABLES(Int16)
NO_VARIABLES(UInt16)
NO_VARIABLES(Int32)
NO_VARIABLES(UInt32)
NO_VARIABLES(Int64)
NO_VARIABLES(UInt64)
NO_VARIABLES(Boolean)
NO_VARIABLES(String)

fmi3Status fmi3GetBinary(REFERENCES, size_t sizes[], fmi3Binary values[], size_t n_values)
{
    UNUSED(references), UNUSED(sizes), UNUSED(values), UNUSED(n_values);
    return MISSING("variables of the type Binary");
}

fmi3Status fmi3SetBinary(REFERENCES, const size_t sizes[], const fmi3Binary values[],
    size_t n_values)
{
    UNUSED(references), UNUSED(sizes), UNUSED(values), UNUSED(n_values);
    return MISSING("variables of the type Binary");
}

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance instance,
    fmi3ValueReference reference, size_t *count)
{
    UNUSED(reference), UNUSED(count);
    return STATUS(failed(C, "dependencies are told in the description alone", 0));
}

fmi3Status fmi3GetVariableDependencies(fmi3Instance instance, fmi3ValueReference dependent,
    size_t dependents[], fmi3ValueReference independents[], size_t elements[],
    fmi3DependencyKind kinds[], size_t count)
{
    UNUSED(dependent), UNUSED(dependents), UNUSED(independents), UNUSED(elements), UNUSED(kinds);
    UNUSED(count);
    return STATUS(failed(C, "dependencies are told in the description alone", 0));
}

fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState *kept)
{
    if (!*kept && !(*kept = malloc(sizeof(values_t))))
        return STATUS(failed(C, "no memory for a state", 0));
    memcpy(*kept, &C->now, sizeof(values_t));
    return fmi3OK;
}

fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState kept)
{
    memcpy(&C->now, kept, sizeof(values_t));
    C->stale = 1;
    return fmi3OK;
}

fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState *kept)
{
    UNUSED(instance);
    free(*kept);
    *kept = NULL;
    return fmi3OK;
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance instance, fmi3FMUState kept, size_t *size)
{
    UNUSED(instance), UNUSED(kept);
    *size = sizeof(values_t);
    return fmi3OK;
}

fmi3Status fmi3SerializeFMUState(fmi3Instance instance, fmi3FMUState kept, fmi3Byte bytes[],
    size_t size)
{
    if (size < sizeof(values_t))
        return STATUS(failed(C, "a state does not go into %.0f bytes", (double)size));
    memcpy(bytes, kept, sizeof(values_t));
    return fmi3OK;
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance instance, const fmi3Byte bytes[], size_t size,
    fmi3FMUState *kept)
{
    if (size != sizeof(values_t))
        return STATUS(failed(C, "%.0f bytes are no state", (double)size));
    if (!*kept && !(*kept = malloc(sizeof(values_t))))
        return STATUS(failed(C, "no memory for a state", 0));
    memcpy(*kept, bytes, sizeof(values_t));
    return fmi3OK;
}

fmi3Status fmi3GetDirectionalDerivative(fmi3Instance instance,
    const fmi3ValueReference unknowns[], size_t n_unknowns, const fmi3ValueReference knowns[],
    size_t n_knowns, const fmi3Float64 seed[], size_t n_seed, fmi3Float64 change[],
    size_t n_change)
{
    UNUSED(n_seed), UNUSED(n_change);
    return STATUS(derive(C, unknowns, n_unknowns, knowns, n_knowns, seed, change));
}

fmi3Status fmi3GetAdjointDerivative(fmi3Instance instance, const fmi3ValueReference unknowns[],
    size_t n_unknowns, const fmi3ValueReference knowns[], size_t n_knowns,
    const fmi3Float64 seed[], size_t n_seed, fmi3Float64 change[], size_t n_change)
{
    UNUSED(unknowns), UNUSED(n_unknowns), UNUSED(knowns), UNUSED(n_knowns), UNUSED(seed);
    UNUSED(n_seed), UNUSED(change), UNUSED(n_change);
    return STATUS(failed(C, "there are no adjoint derivatives", 0));
}

/* --- Clocks, of which there is none --- */

#define NO_CLOCKS(name, ...) \
    fmi3Status name(REFERENCES, __VA_ARGS__) \
    { \
        UNUSED(references), UNUSED(a); \
        return MISSING("clocks"); \
    }
#define NO_CLOCKS_2(name, ...) \
    fmi3Status name(REFERENCES, __VA_ARGS__) \
    { \
        UNUSED(references), UNUSED(a), UNUSED(b); \
        return MISSING("clocks"); \
    }
NO_CLOCKS(fmi3GetClock, fmi3Clock a[])
NO_CLOCKS(fmi3SetClock, const fmi3Clock a[])
NO_CLOCKS(fmi3GetShiftDecimal, fmi3Float64 a[])
NO_CLOCKS(fmi3SetShiftDecimal, const fmi3Float64 a[])
NO_CLOCKS(fmi3SetIntervalDecimal, const fmi3Float64 a[])
NO_CLOCKS_2(fmi3GetIntervalDecimal, fmi3Float64 a[], fmi3IntervalQualifier b[])
NO_CLOCKS_2(fmi3GetShiftFraction, fmi3UInt64 a[], fmi3UInt64 b[])
NO_CLOCKS_2(fmi3SetShiftFraction, const fmi3UInt64 a[], const fmi3UInt64 b[])
NO_CLOCKS_2(fmi3SetIntervalFraction, const fmi3UInt64 a[], const fmi3UInt64 b[])

fmi3Status fmi3GetIntervalFraction(REFERENCES, fmi3UInt64 counters[], fmi3UInt64 resolutions[],
    fmi3IntervalQualifier qualifiers[])
{
    UNUSED(references), UNUSED(counters), UNUSED(resolutions), UNUSED(qualifiers);
    return MISSING("clocks");
}

fmi3Status fmi3ActivateModelPartition(fmi3Instance instance, fmi3ValueReference clock,
    fmi3Float64 time)
{
    UNUSED(clock), UNUSED(time);
    return STATUS(failed(C, "there are no clocks", 0));
}

/* --- Model exchange --- */

fmi3Status fmi3UpdateDiscreteStates(fmi3Instance instance, fmi3Boolean *again,
    fmi3Boolean *terminate, fmi3Boolean *new_nominals, fmi3Boolean *new_states,
    fmi3Boolean *has_next, fmi3Float64 *next)
{
    UNUSED(instance);
    *again = *terminate = *new_nominals = *new_states = *has_next = fmi3False;
    *next = 0;
    return fmi3OK;
}

fmi3Status fmi3CompletedIntegratorStep(fmi3Instance instance, fmi3Boolean forever,
    fmi3Boolean *enter_event_mode, fmi3Boolean *terminate)
{
    UNUSED(instance), UNUSED(forever);
    *enter_event_mode = *terminate = fmi3False;
    return fmi3OK;
}

fmi3Status fmi3SetTime(fmi3Instance instance, fmi3Float64 time)
{
    C->now.time = time;
    return fmi3OK;
}

fmi3Status fmi3SetContinuousStates(fmi3Instance instance, const fmi3Float64 x[], size_t count)
{
    return STATUS(set_states(C, x, count));
}

fmi3Status fmi3GetContinuousStates(fmi3Instance instance, fmi3Float64 x[], size_t count)
{
    return STATUS(get_states(C, X, x, count));
}

fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance instance, fmi3Float64 dx[],
    size_t count)
{
    return STATUS(get_states(C, DX, dx, count));
}

fmi3Status fmi3GetEventIndicators(fmi3Instance instance, fmi3Float64 indicators[], size_t count)
{
    UNUSED(indicators);
    return MISSING("event indicators");
}

fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance instance, fmi3Float64 nominals[],
    size_t count)
{
    UNUSED(instance);
    for (size_t k = 0; k < count; ++k)
        nominals[k] = 1;
    return fmi3OK;
}

fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance instance, size_t *count)
{
    UNUSED(instance);
    *count = 0;
    return fmi3OK;
}

fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance instance, size_t *count)
{
    UNUSED(instance);
    *count = NX;
    return fmi3OK;
}

/* --- Co-simulation --- */

fmi3Status fmi3GetOutputDerivatives(fmi3Instance instance, const fmi3ValueReference references[],
    size_t count, const fmi3Int32 orders[], fmi3Float64 values[], size_t n_values)
{
    UNUSED(references), UNUSED(orders), UNUSED(values), UNUSED(n_values);
    return MISSING("derivatives of outputs");
}

fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 time, fmi3Float64 length,
    fmi3Boolean forever, fmi3Boolean *event, fmi3Boolean *terminate, fmi3Boolean *early,
    fmi3Float64 *last)
{
    UNUSED(forever);
    const int failure = advance(C, time, length);
    *event = *terminate = *early = fmi3False;
    *last = C->now.time;
    return STATUS(failure);
}
