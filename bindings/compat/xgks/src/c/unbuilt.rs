//! The functions of the draft that are not built: input and GKS metafiles in C. The Fortran binding has them where
//! the kernel has.

use super::argument::{call, inquire};
use super::types::Gint;
use gks::{Error, Function, Gks};
use gks_pipeline::generated::numbers::ERROR_LEVEL_NOT_BUILT;

fn missing(gks: &Gks, function: Function) -> gks::Result<()> {
    gks_instance::check_state(gks, function)?;
    Err(Error::new(ERROR_LEVEL_NOT_BUILT, function))
}

/// Functions that refuse, whatever their arguments are.
macro_rules! unbuilt {
    ($how:ident: $($name:ident $function:ident)+) => { $(
        #[doc = concat!("Refuses `", stringify!($function), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name() -> Gint {
            $how(Function::$function, |gks| missing(gks, Function::$function))
        }
    )+ };
}

unbuilt! { call:
    gsetpickid SetPickIdentifier
    ginitloc InitialiseLocator
    ginitstroke InitialiseStroke
    ginitval InitialiseValuator
    ginitchoice InitialiseChoice
    ginitpick InitialisePick
    ginitstring InitialiseString
    gsetlocmode SetLocatorMode
    gsetstrokemode SetStrokeMode
    gsetvalmode SetValuatorMode
    gsetchoicemode SetChoiceMode
    gsetpickmode SetPickMode
    gsetstringmode SetStringMode
    greqloc RequestLocator
    greqstroke RequestStroke
    greqval RequestValuator
    greqchoice RequestChoice
    greqpick RequestPick
    greqstring RequestString
    gsampleloc SampleLocator
    gsamplestroke SampleStroke
    gsampleval SampleValuator
    gsamplechoice SampleChoice
    gsamplepick SamplePick
    gsamplestring SampleString
    gawaitevent AwaitEvent
    gflushevents FlushDeviceEvents
    ggetloc GetLocator
    ggetstroke GetStroke
    ggetval GetValuator
    ggetchoice GetChoice
    ggetpick GetPick
    ggetstring GetString
    gwritegksm WriteItemToGksm
    ggetgksm GetItemTypeFromGksm
    greadgksm ReadItemFromGksm
    ginterpret InterpretItem
}

unbuilt! { inquire:
    ginqcurpickid InquireCurrentPickIdentifierValue
    ginqlocst InquireLocatorDeviceState
    ginqstrokest InquireStrokeDeviceState
    ginqvalst InquireValuatorDeviceState
    ginqchoicest InquireChoiceDeviceState
    ginqpickst InquirePickDeviceState
    ginqstringst InquireStringDeviceState
    ginqdefloc InquireDefaultLocatorDeviceData
    ginqdefstroke InquireDefaultStrokeDeviceData
    ginqdefval InquireDefaultValuatorDeviceData
    ginqdefchoice InquireDefaultChoiceDeviceData
    ginqdefpick InquireDefaultPickDeviceData
    ginqdefstring InquireDefaultStringDeviceData
    ginqinputoverflow InquireInputQueueOverflow
    ginqmoreevents InquireMoreSimultaneousEvents
    ginqnumavailinput InquireNumberOfAvailableLogicalInputDevices
}
