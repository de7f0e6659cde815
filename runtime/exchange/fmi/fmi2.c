/* The component in version 2.0 of FMI. */
#include "component.c"
#include "fmi2Functions.h"
#include "token.h"

#define C ((component *)instance)
#define STATUS(failure) ((failure) ? fmi2Error : fmi2OK)
#define UNUSED(name) (void)(name)

static void tell(component *c, const char *message)
{
    const fmi2CallbackFunctions *callbacks = c->logger;
    if (callbacks && callbacks->logger)
        callbacks->logger(c->environment, c->name, fmi2Error, "logStatusError", "%s", message);
}

const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }

const char *fmi2GetVersion(void) { return fmi2Version; }

fmi2Status fmi2SetDebugLogging(fmi2Component instance, fmi2Boolean on, size_t count,
    const fmi2String categories[])
{
    UNUSED(instance), UNUSED(on), UNUSED(count), UNUSED(categories);
    return fmi2OK;
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String token, fmi2String place,
    const fmi2CallbackFunctions *callbacks, fmi2Boolean visible, fmi2Boolean logging)
{
    UNUSED(type), UNUSED(place), UNUSED(visible), UNUSED(logging);
    component *c = created(name ? name : "", callbacks ? callbacks->componentEnvironment : NULL);
    if (!c)
        return NULL;
    c->logger = (void *)callbacks;
    c->tell = tell;
    if (!token || strcmp(token, TOKEN)) {
        failed(c, "the description belongs to another component: wrong guid", 0);
        removed(c);
        return NULL;
    }
    return c;
}

void fmi2FreeInstance(fmi2Component instance) { removed(C); }

fmi2Status fmi2SetupExperiment(fmi2Component instance, fmi2Boolean has_tolerance,
    fmi2Real tolerance, fmi2Real start, fmi2Boolean has_stop, fmi2Real stop)
{
    UNUSED(has_stop), UNUSED(stop);
    C->now.time = start;
    if (has_tolerance && tolerance > 0)
        C->tolerance = tolerance;
    return fmi2OK;
}

fmi2Status fmi2Reset(fmi2Component instance)
{
    reset(C);
    return fmi2OK;
}

#define NOTHING(name) \
    fmi2Status name(fmi2Component instance) \
    { \
        UNUSED(instance); \
        return fmi2OK; \
    }
NOTHING(fmi2EnterInitializationMode)
NOTHING(fmi2ExitInitializationMode)
NOTHING(fmi2Terminate)
NOTHING(fmi2EnterEventMode)
NOTHING(fmi2EnterContinuousTimeMode)

/* --- Values --- */

fmi2Status fmi2GetReal(fmi2Component instance, const fmi2ValueReference references[],
    size_t count, fmi2Real values[])
{
    return STATUS(get(C, references, count, values));
}

fmi2Status fmi2SetReal(fmi2Component instance, const fmi2ValueReference references[],
    size_t count, const fmi2Real values[])
{
    return STATUS(set(C, references, count, values));
}

/* Of other types there is no variable. */
#define NO_VARIABLES(type, values_t) \
    fmi2Status fmi2Get##type(fmi2Component instance, const fmi2ValueReference references[], \
        size_t count, values_t values[]) \
    { \
        UNUSED(references), UNUSED(values); \
        return STATUS(count && failed(C, "there are no variables of the type " #type, 0)); \
    } \
    fmi2Status fmi2Set##type(fmi2Component instance, const fmi2ValueReference references[], \
        size_t count, const values_t values[]) \
    { \
        UNUSED(references), UNUSED(values); \
        return STATUS(count && failed(C, "there are no variables of the type " #type, 0)); \
    }
NO_VARIABLES(Integer, fmi2Integer)
NO_VARIABLES(Boolean, fmi2Boolean)
NO_VARIABLES(String, fmi2String)

fmi2Status fmi2GetFMUstate(fmi2Component instance, fmi2FMUstate *kept)
{
    if (!*kept && !(*kept = malloc(sizeof(values_t))))
        return STATUS(failed(C, "no memory for a state", 0));
    memcpy(*kept, &C->now, sizeof(values_t));
    return fmi2OK;
}

fmi2Status fmi2SetFMUstate(fmi2Component instance, fmi2FMUstate kept)
{
    memcpy(&C->now, kept, sizeof(values_t));
    C->stale = 1;
    return fmi2OK;
}

fmi2Status fmi2FreeFMUstate(fmi2Component instance, fmi2FMUstate *kept)
{
    UNUSED(instance);
    free(*kept);
    *kept = NULL;
    return fmi2OK;
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component instance, fmi2FMUstate kept, size_t *size)
{
    UNUSED(instance), UNUSED(kept);
    *size = sizeof(values_t);
    return fmi2OK;
}

fmi2Status fmi2SerializeFMUstate(fmi2Component instance, fmi2FMUstate kept, fmi2Byte bytes[],
    size_t size)
{
    if (size < sizeof(values_t))
        return STATUS(failed(C, "a state does not go into %.0f bytes", (double)size));
    memcpy(bytes, kept, sizeof(values_t));
    return fmi2OK;
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component instance, const fmi2Byte bytes[], size_t size,
    fmi2FMUstate *kept)
{
    if (size != sizeof(values_t))
        return STATUS(failed(C, "%.0f bytes are no state", (double)size));
    if (!*kept && !(*kept = malloc(sizeof(values_t))))
        return STATUS(failed(C, "no memory for a state", 0));
    memcpy(*kept, bytes, sizeof(values_t));
    return fmi2OK;
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component instance,
    const fmi2ValueReference unknowns[], size_t n_unknowns, const fmi2ValueReference knowns[],
    size_t n_knowns, const fmi2Real seed[], fmi2Real change[])
{
    return STATUS(derive(C, unknowns, n_unknowns, knowns, n_knowns, seed, change));
}

/* --- Model exchange --- */

fmi2Status fmi2NewDiscreteStates(fmi2Component instance, fmi2EventInfo *info)
{
    UNUSED(instance);
    memset(info, 0, sizeof *info);
    return fmi2OK;
}

fmi2Status fmi2CompletedIntegratorStep(fmi2Component instance, fmi2Boolean forever,
    fmi2Boolean *enter_event_mode, fmi2Boolean *terminate)
{
    UNUSED(instance), UNUSED(forever);
    *enter_event_mode = *terminate = fmi2False;
    return fmi2OK;
}

fmi2Status fmi2SetTime(fmi2Component instance, fmi2Real time)
{
    C->now.time = time;
    return fmi2OK;
}

fmi2Status fmi2SetContinuousStates(fmi2Component instance, const fmi2Real x[], size_t count)
{
    return STATUS(set_states(C, x, count));
}

fmi2Status fmi2GetContinuousStates(fmi2Component instance, fmi2Real x[], size_t count)
{
    return STATUS(get_states(C, X, x, count));
}

fmi2Status fmi2GetDerivatives(fmi2Component instance, fmi2Real dx[], size_t count)
{
    return STATUS(get_states(C, DX, dx, count));
}

fmi2Status fmi2GetEventIndicators(fmi2Component instance, fmi2Real indicators[], size_t count)
{
    UNUSED(indicators);
    return STATUS(count && failed(C, "there are no event indicators", 0));
}

fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component instance, fmi2Real nominals[],
    size_t count)
{
    UNUSED(instance);
    for (size_t k = 0; k < count; ++k)
        nominals[k] = 1;
    return fmi2OK;
}

/* --- Co-simulation --- */

fmi2Status fmi2DoStep(fmi2Component instance, fmi2Real time, fmi2Real length, fmi2Boolean forever)
{
    UNUSED(forever);
    return STATUS(advance(C, time, length));
}

fmi2Status fmi2CancelStep(fmi2Component instance)
{
    return STATUS(failed(C, "steps cannot be cancelled", 0));
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component instance, const fmi2ValueReference references[],
    size_t count, const fmi2Integer order[], const fmi2Real values[])
{
    UNUSED(references), UNUSED(order), UNUSED(values);
    return STATUS(count && failed(C, "inputs are constant over a step", 0));
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component instance,
    const fmi2ValueReference references[], size_t count, const fmi2Integer order[],
    fmi2Real values[])
{
    UNUSED(references), UNUSED(order), UNUSED(values);
    return STATUS(count && failed(C, "outputs have no derivatives", 0));
}

fmi2Status fmi2GetRealStatus(fmi2Component instance, const fmi2StatusKind kind, fmi2Real *value)
{
    *value = C->now.time;
    return kind == fmi2LastSuccessfulTime ? fmi2OK : fmi2Discard;
}

#define NO_STATUS(name, value_t) \
    fmi2Status name(fmi2Component instance, const fmi2StatusKind kind, value_t *value) \
    { \
        UNUSED(instance), UNUSED(kind), UNUSED(value); \
        return fmi2Discard; \
    }
NO_STATUS(fmi2GetStatus, fmi2Status)
NO_STATUS(fmi2GetIntegerStatus, fmi2Integer)
NO_STATUS(fmi2GetBooleanStatus, fmi2Boolean)
NO_STATUS(fmi2GetStringStatus, fmi2String)
