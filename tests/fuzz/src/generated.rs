//! How every subroutine of the Fortran binding is called with arbitrary arguments.
//!
//! Written by `gks-spec generate` from `spec/gks/functions.toml`; do not edit.

use crate::arguments::Arguments;

/// A subroutine.
pub(crate) struct Subroutine {
    /// Its name.
    pub(crate) name: &'static str,
    /// Calls it.
    pub(crate) call: fn(&mut Arguments<'_>),
}

unsafe extern "C" {
    pub(crate) fn gopks_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gclks_();
    pub(crate) fn gopwk_(p0: *mut i32, p1: *mut i32, p2: *mut i32);
    pub(crate) fn gclwk_(p0: *mut i32);
    pub(crate) fn gacwk_(p0: *mut i32);
    pub(crate) fn gdawk_(p0: *mut i32);
    pub(crate) fn gclrwk_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn grsgwk_(p0: *mut i32);
    pub(crate) fn guwk_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gsds_(p0: *mut i32, p1: *mut i32, p2: *mut i32);
    pub(crate) fn gmsg_(p0: *mut i32, p1: *mut u8, p2: usize);
    pub(crate) fn gmsgs_(p0: *mut i32, p1: *mut i32, p2: *mut u8, p3: usize);
    pub(crate) fn gesc_(p0: *mut i32, p1: *mut i32, p2: *mut u8, p3: *mut i32, p4: *mut i32, p5: *mut u8, p6: usize, p7: usize);
    pub(crate) fn gpl_(p0: *mut i32, p1: *mut f32, p2: *mut f32);
    pub(crate) fn gpm_(p0: *mut i32, p1: *mut f32, p2: *mut f32);
    pub(crate) fn gtx_(p0: *mut f32, p1: *mut f32, p2: *mut u8, p3: usize);
    pub(crate) fn gtxs_(p0: *mut f32, p1: *mut f32, p2: *mut i32, p3: *mut u8, p4: usize);
    pub(crate) fn gfa_(p0: *mut i32, p1: *mut f32, p2: *mut f32);
    pub(crate) fn gca_(p0: *mut f32, p1: *mut f32, p2: *mut f32, p3: *mut f32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut i32, p8: *mut i32, p9: *mut i32, p10: *mut i32);
    pub(crate) fn ggdp_(p0: *mut i32, p1: *mut f32, p2: *mut f32, p3: *mut i32, p4: *mut i32, p5: *mut u8, p6: usize);
    pub(crate) fn gspli_(p0: *mut i32);
    pub(crate) fn gsln_(p0: *mut i32);
    pub(crate) fn gslwsc_(p0: *mut f32);
    pub(crate) fn gsplci_(p0: *mut i32);
    pub(crate) fn gspmi_(p0: *mut i32);
    pub(crate) fn gsmk_(p0: *mut i32);
    pub(crate) fn gsmksc_(p0: *mut f32);
    pub(crate) fn gspmci_(p0: *mut i32);
    pub(crate) fn gstxi_(p0: *mut i32);
    pub(crate) fn gstxfp_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gschxp_(p0: *mut f32);
    pub(crate) fn gschsp_(p0: *mut f32);
    pub(crate) fn gstxci_(p0: *mut i32);
    pub(crate) fn gschh_(p0: *mut f32);
    pub(crate) fn gschup_(p0: *mut f32, p1: *mut f32);
    pub(crate) fn gstxp_(p0: *mut i32);
    pub(crate) fn gstxal_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gsfai_(p0: *mut i32);
    pub(crate) fn gsfais_(p0: *mut i32);
    pub(crate) fn gsfasi_(p0: *mut i32);
    pub(crate) fn gsfaci_(p0: *mut i32);
    pub(crate) fn gspa_(p0: *mut f32, p1: *mut f32);
    pub(crate) fn gsparf_(p0: *mut f32, p1: *mut f32);
    pub(crate) fn gsasf_(p0: *mut i32);
    pub(crate) fn gspkid_(p0: *mut i32);
    pub(crate) fn gsplr_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut f32, p4: *mut i32);
    pub(crate) fn gspmr_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut f32, p4: *mut i32);
    pub(crate) fn gstxr_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut f32, p5: *mut f32, p6: *mut i32);
    pub(crate) fn gsfar_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32);
    pub(crate) fn gspar_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut i32, p8: *mut i32);
    pub(crate) fn gscr_(p0: *mut i32, p1: *mut i32, p2: *mut f32, p3: *mut f32, p4: *mut f32);
    pub(crate) fn gswn_(p0: *mut i32, p1: *mut f32, p2: *mut f32, p3: *mut f32, p4: *mut f32);
    pub(crate) fn gsvp_(p0: *mut i32, p1: *mut f32, p2: *mut f32, p3: *mut f32, p4: *mut f32);
    pub(crate) fn gsvpip_(p0: *mut i32, p1: *mut i32, p2: *mut i32);
    pub(crate) fn gselnt_(p0: *mut i32);
    pub(crate) fn gsclip_(p0: *mut i32);
    pub(crate) fn gswkwn_(p0: *mut i32, p1: *mut f32, p2: *mut f32, p3: *mut f32, p4: *mut f32);
    pub(crate) fn gswkvp_(p0: *mut i32, p1: *mut f32, p2: *mut f32, p3: *mut f32, p4: *mut f32);
    pub(crate) fn gcrsg_(p0: *mut i32);
    pub(crate) fn gclsg_();
    pub(crate) fn grensg_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gdsg_(p0: *mut i32);
    pub(crate) fn gdsgwk_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gasgwk_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gcsgwk_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn ginsg_(p0: *mut i32, p1: *mut f32);
    pub(crate) fn gssgt_(p0: *mut i32, p1: *mut f32);
    pub(crate) fn gsvis_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gshlit_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gssgp_(p0: *mut i32, p1: *mut f32);
    pub(crate) fn gsdtec_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn ginlc_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut f32, p4: *mut f32, p5: *mut i32, p6: *mut f32, p7: *mut f32, p8: *mut f32, p9: *mut f32, p10: *mut i32, p11: *mut u8, p12: usize);
    pub(crate) fn ginsk_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut f32, p5: *mut f32, p6: *mut i32, p7: *mut f32, p8: *mut f32, p9: *mut f32, p10: *mut f32, p11: *mut i32, p12: *mut i32, p13: *mut u8, p14: usize);
    pub(crate) fn ginvl_(p0: *mut i32, p1: *mut i32, p2: *mut f32, p3: *mut i32, p4: *mut f32, p5: *mut f32, p6: *mut f32, p7: *mut f32, p8: *mut f32, p9: *mut f32, p10: *mut i32, p11: *mut u8, p12: usize);
    pub(crate) fn ginch_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut f32, p6: *mut f32, p7: *mut f32, p8: *mut f32, p9: *mut i32, p10: *mut u8, p11: usize);
    pub(crate) fn ginpk_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut f32, p7: *mut f32, p8: *mut f32, p9: *mut f32, p10: *mut i32, p11: *mut u8, p12: usize);
    pub(crate) fn ginst_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut u8, p4: *mut i32, p5: *mut f32, p6: *mut f32, p7: *mut f32, p8: *mut f32, p9: *mut i32, p10: *mut i32, p11: *mut i32, p12: *mut u8, p13: usize, p14: usize);
    pub(crate) fn ginsts_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut u8, p4: *mut i32, p5: *mut f32, p6: *mut f32, p7: *mut f32, p8: *mut f32, p9: *mut i32, p10: *mut i32, p11: *mut i32, p12: *mut u8, p13: usize, p14: usize);
    pub(crate) fn gslcm_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32);
    pub(crate) fn gsskm_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32);
    pub(crate) fn gsvlm_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32);
    pub(crate) fn gschm_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32);
    pub(crate) fn gspkm_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32);
    pub(crate) fn gsstm_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32);
    pub(crate) fn grqlc_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut f32, p5: *mut f32);
    pub(crate) fn grqsk_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut f32, p7: *mut f32);
    pub(crate) fn grqvl_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut f32);
    pub(crate) fn grqch_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32);
    pub(crate) fn grqpk_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32);
    pub(crate) fn grqst_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut u8, p5: usize);
    pub(crate) fn grqsts_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut u8, p5: usize);
    pub(crate) fn gsmlc_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut f32, p4: *mut f32);
    pub(crate) fn gsmsk_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut f32, p6: *mut f32);
    pub(crate) fn gsmvl_(p0: *mut i32, p1: *mut i32, p2: *mut f32);
    pub(crate) fn gsmch_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32);
    pub(crate) fn gsmpk_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32);
    pub(crate) fn gsmst_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut u8, p4: usize);
    pub(crate) fn gsmsts_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut u8, p4: usize);
    pub(crate) fn gwait_(p0: *mut f32, p1: *mut i32, p2: *mut i32, p3: *mut i32);
    pub(crate) fn gflush_(p0: *mut i32, p1: *mut i32, p2: *mut i32);
    pub(crate) fn ggtlc_(p0: *mut i32, p1: *mut f32, p2: *mut f32);
    pub(crate) fn ggtsk_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut f32, p4: *mut f32);
    pub(crate) fn ggtvl_(p0: *mut f32);
    pub(crate) fn ggtch_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn ggtpk_(p0: *mut i32, p1: *mut i32, p2: *mut i32);
    pub(crate) fn ggtst_(p0: *mut i32, p1: *mut u8, p2: usize);
    pub(crate) fn ggtsts_(p0: *mut i32, p1: *mut u8, p2: usize);
    pub(crate) fn gwitm_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut u8, p5: usize);
    pub(crate) fn ggtitm_(p0: *mut i32, p1: *mut i32, p2: *mut i32);
    pub(crate) fn grditm_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut u8, p4: usize);
    pub(crate) fn giitm_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut u8, p4: usize);
    pub(crate) fn gqops_(p0: *mut i32);
    pub(crate) fn gqlvks_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqewk_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32);
    pub(crate) fn gqwkm_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32);
    pub(crate) fn gqmntn_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqopwk_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32);
    pub(crate) fn gqacwk_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32);
    pub(crate) fn gqpli_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqpmi_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqtxi_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqchh_(p0: *mut i32, p1: *mut f32);
    pub(crate) fn gqchup_(p0: *mut i32, p1: *mut f32, p2: *mut f32);
    pub(crate) fn gqchw_(p0: *mut i32, p1: *mut f32);
    pub(crate) fn gqchb_(p0: *mut i32, p1: *mut f32, p2: *mut f32);
    pub(crate) fn gqtxp_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqtxal_(p0: *mut i32, p1: *mut i32, p2: *mut i32);
    pub(crate) fn gqfai_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqpa_(p0: *mut i32, p1: *mut f32, p2: *mut f32, p3: *mut f32, p4: *mut f32);
    pub(crate) fn gqparf_(p0: *mut i32, p1: *mut f32, p2: *mut f32);
    pub(crate) fn gqpkid_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqln_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqlwsc_(p0: *mut i32, p1: *mut f32);
    pub(crate) fn gqplci_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqmk_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqmksc_(p0: *mut i32, p1: *mut f32);
    pub(crate) fn gqpmci_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqtxfp_(p0: *mut i32, p1: *mut i32, p2: *mut i32);
    pub(crate) fn gqchxp_(p0: *mut i32, p1: *mut f32);
    pub(crate) fn gqchsp_(p0: *mut i32, p1: *mut f32);
    pub(crate) fn gqtxci_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqfais_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqfasi_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqfaci_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqasf_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqcntn_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqentn_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32);
    pub(crate) fn gqnt_(p0: *mut i32, p1: *mut i32, p2: *mut f32, p3: *mut f32);
    pub(crate) fn gqclip_(p0: *mut i32, p1: *mut i32, p2: *mut f32);
    pub(crate) fn gqopsg_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqsgus_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32);
    pub(crate) fn gqsim_(p0: *mut i32, p1: *mut i32);
    pub(crate) fn gqwkc_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32);
    pub(crate) fn gqwks_(p0: *mut i32, p1: *mut i32, p2: *mut i32);
    pub(crate) fn gqwkdu_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32);
    pub(crate) fn gqepli_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32);
    pub(crate) fn gqplr_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut f32, p6: *mut i32);
    pub(crate) fn gqepmi_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32);
    pub(crate) fn gqpmr_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut f32, p6: *mut i32);
    pub(crate) fn gqetxi_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32);
    pub(crate) fn gqtxr_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut f32, p7: *mut f32, p8: *mut i32);
    pub(crate) fn gqtxx_(p0: *mut i32, p1: *mut f32, p2: *mut f32, p3: *mut u8, p4: *mut i32, p5: *mut f32, p6: *mut f32, p7: *mut f32, p8: *mut f32, p9: usize);
    pub(crate) fn gqtxxs_(p0: *mut i32, p1: *mut f32, p2: *mut f32, p3: *mut i32, p4: *mut u8, p5: *mut i32, p6: *mut f32, p7: *mut f32, p8: *mut f32, p9: *mut f32, p10: usize);
    pub(crate) fn gqefai_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32);
    pub(crate) fn gqfar_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32);
    pub(crate) fn gqepai_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32);
    pub(crate) fn gqpar_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut i32, p8: *mut i32);
    pub(crate) fn gqeci_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32);
    pub(crate) fn gqcr_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut f32, p5: *mut f32, p6: *mut f32);
    pub(crate) fn gqwkt_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut f32, p4: *mut f32, p5: *mut f32, p6: *mut f32);
    pub(crate) fn gqsgwk_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32);
    pub(crate) fn gqlcs_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut i32, p8: *mut f32, p9: *mut f32, p10: *mut i32, p11: *mut f32, p12: *mut i32, p13: *mut u8, p14: usize);
    pub(crate) fn gqsks_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut i32, p8: *mut i32, p9: *mut i32, p10: *mut f32, p11: *mut f32, p12: *mut i32, p13: *mut f32, p14: *mut i32, p15: *mut i32, p16: *mut u8, p17: usize);
    pub(crate) fn gqvls_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut f32, p7: *mut i32, p8: *mut f32, p9: *mut f32, p10: *mut f32, p11: *mut i32, p12: *mut u8, p13: usize);
    pub(crate) fn gqchs_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut i32, p8: *mut i32, p9: *mut f32, p10: *mut i32, p11: *mut u8, p12: usize);
    pub(crate) fn gqpks_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut i32, p8: *mut i32, p9: *mut i32, p10: *mut i32, p11: *mut f32, p12: *mut i32, p13: *mut u8, p14: usize);
    pub(crate) fn gqsts_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut u8, p8: *mut i32, p9: *mut f32, p10: *mut i32, p11: *mut i32, p12: *mut i32, p13: *mut u8, p14: usize, p15: usize);
    pub(crate) fn gqstss_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut u8, p8: *mut i32, p9: *mut f32, p10: *mut i32, p11: *mut i32, p12: *mut i32, p13: *mut u8, p14: usize, p15: usize);
    pub(crate) fn gqwkca_(p0: *mut i32, p1: *mut i32, p2: *mut i32);
    pub(crate) fn gqwkcl_(p0: *mut i32, p1: *mut i32, p2: *mut i32);
    pub(crate) fn gqdsp_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut f32, p4: *mut f32, p5: *mut i32, p6: *mut i32);
    pub(crate) fn gqdwka_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut i32, p8: *mut i32);
    pub(crate) fn gqdds_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32);
    pub(crate) fn gqplf_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut f32, p7: *mut f32, p8: *mut f32, p9: *mut i32);
    pub(crate) fn gqpplr_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut f32, p5: *mut i32);
    pub(crate) fn gqpmf_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut f32, p7: *mut f32, p8: *mut f32, p9: *mut i32);
    pub(crate) fn gqppmr_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut f32, p5: *mut i32);
    pub(crate) fn gqtxf_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut f32, p8: *mut f32, p9: *mut i32, p10: *mut f32, p11: *mut f32, p12: *mut i32);
    pub(crate) fn gqptxr_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut f32, p6: *mut f32, p7: *mut i32);
    pub(crate) fn gqfaf_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut i32, p8: *mut i32);
    pub(crate) fn gqpfar_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32);
    pub(crate) fn gqpaf_(p0: *mut i32, p1: *mut i32, p2: *mut i32);
    pub(crate) fn gqppar_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut i32);
    pub(crate) fn gqcf_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32);
    pub(crate) fn gqpcr_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut f32, p4: *mut f32, p5: *mut f32);
    pub(crate) fn gqegdp_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32);
    pub(crate) fn gqgdp_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32);
    pub(crate) fn gqlwk_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut i32);
    pub(crate) fn gqsgp_(p0: *mut i32, p1: *mut i32, p2: *mut i32);
    pub(crate) fn gqdsga_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut i32, p8: *mut i32);
    pub(crate) fn gqli_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut i32);
    pub(crate) fn gqdlc_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut f32, p6: *mut f32, p7: *mut i32, p8: *mut i32, p9: *mut f32, p10: *mut i32, p11: *mut u8, p12: usize);
    pub(crate) fn gqdsk_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut i32, p8: *mut f32, p9: *mut i32, p10: *mut i32, p11: *mut u8, p12: usize);
    pub(crate) fn gqdvl_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut f32, p6: *mut i32, p7: *mut i32, p8: *mut f32, p9: *mut f32, p10: *mut f32, p11: *mut i32, p12: *mut u8, p13: usize);
    pub(crate) fn gqdch_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut i32, p8: *mut f32, p9: *mut i32, p10: *mut u8, p11: usize);
    pub(crate) fn gqdpk_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut f32, p8: *mut i32, p9: *mut u8, p10: usize);
    pub(crate) fn gqdst_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut i32, p8: *mut f32, p9: *mut i32, p10: *mut i32, p11: *mut u8, p12: usize);
    pub(crate) fn gqaswk_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32, p4: *mut i32);
    pub(crate) fn gqsga_(p0: *mut i32, p1: *mut i32, p2: *mut f32, p3: *mut i32, p4: *mut i32, p5: *mut f32, p6: *mut i32);
    pub(crate) fn gqpxad_(p0: *mut i32, p1: *mut f32, p2: *mut f32, p3: *mut f32, p4: *mut f32, p5: *mut i32, p6: *mut i32, p7: *mut i32);
    pub(crate) fn gqpxa_(p0: *mut i32, p1: *mut f32, p2: *mut f32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut i32, p8: *mut i32, p9: *mut i32, p10: *mut i32, p11: *mut i32);
    pub(crate) fn gqpx_(p0: *mut i32, p1: *mut f32, p2: *mut f32, p3: *mut i32, p4: *mut i32);
    pub(crate) fn gqiqov_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut i32);
    pub(crate) fn gevtm_(p0: *mut f32, p1: *mut f32, p2: *mut f32, p3: *mut f32, p4: *mut f32, p5: *mut f32, p6: *mut f32, p7: *mut i32, p8: *mut f32);
    pub(crate) fn gactm_(p0: *mut f32, p1: *mut f32, p2: *mut f32, p3: *mut f32, p4: *mut f32, p5: *mut f32, p6: *mut f32, p7: *mut f32, p8: *mut i32, p9: *mut f32);
    pub(crate) fn geclks_();
    pub(crate) fn gprec_(p0: *mut i32, p1: *mut i32, p2: *mut i32, p3: *mut f32, p4: *mut i32, p5: *mut i32, p6: *mut u8, p7: *mut i32, p8: *mut i32, p9: *mut i32, p10: *mut u8, p11: usize, p12: usize);
    pub(crate) fn gurec_(p0: *mut i32, p1: *mut u8, p2: *mut i32, p3: *mut i32, p4: *mut i32, p5: *mut i32, p6: *mut i32, p7: *mut i32, p8: *mut i32, p9: *mut f32, p10: *mut i32, p11: *mut i32, p12: *mut u8, p13: usize, p14: usize);
}

/// Every subroutine.
pub(crate) static SUBROUTINES: &[Subroutine] = &[
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GOPKS", call: |a| unsafe { gopks_(a.integer(), a.integer()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GCLKS", call: |_| unsafe { gclks_() } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GOPWK", call: |a| unsafe { gopwk_(a.among(1, 7), a.among(1, 9), a.workstation_type()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GCLWK", call: |a| unsafe { gclwk_(a.among(1, 7)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GACWK", call: |a| unsafe { gacwk_(a.among(1, 7)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GDAWK", call: |a| unsafe { gdawk_(a.among(1, 7)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GCLRWK", call: |a| unsafe { gclrwk_(a.among(1, 7), a.among(0, 2)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GRSGWK", call: |a| unsafe { grsgwk_(a.among(1, 7)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GUWK", call: |a| unsafe { guwk_(a.among(1, 7), a.among(0, 2)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSDS", call: |a| unsafe { gsds_(a.among(1, 7), a.among(0, 4), a.among(0, 2)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GMSG", call: |a| unsafe { gmsg_(a.among(1, 7), a.characters(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GMSGS", call: |a| unsafe { gmsgs_(a.among(1, 7), a.integer(), a.characters(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GESC", call: |a| unsafe { gesc_(a.among(-3005, 5), a.count(), a.record(), a.count(), a.output_integers(), a.record(), Arguments::LENGTH, Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GPL", call: |a| unsafe { gpl_(a.count(), a.reals(), a.reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GPM", call: |a| unsafe { gpm_(a.count(), a.reals(), a.reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GTX", call: |a| unsafe { gtx_(a.real(), a.real(), a.characters(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GTXS", call: |a| unsafe { gtxs_(a.real(), a.real(), a.integer(), a.characters(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GFA", call: |a| unsafe { gfa_(a.count(), a.reals(), a.reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GCA", call: |a| unsafe { gca_(a.real(), a.real(), a.real(), a.real(), a.count(), a.count(), a.count(), a.count(), a.count(), a.count(), a.integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GGDP", call: |a| unsafe { ggdp_(a.count(), a.reals(), a.reals(), a.among(-10, 10), a.count(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSPLI", call: |a| unsafe { gspli_(a.integer()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSLN", call: |a| unsafe { gsln_(a.integer()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSLWSC", call: |a| unsafe { gslwsc_(a.real()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSPLCI", call: |a| unsafe { gsplci_(a.integer()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSPMI", call: |a| unsafe { gspmi_(a.integer()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSMK", call: |a| unsafe { gsmk_(a.integer()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSMKSC", call: |a| unsafe { gsmksc_(a.real()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSPMCI", call: |a| unsafe { gspmci_(a.integer()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSTXI", call: |a| unsafe { gstxi_(a.integer()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSTXFP", call: |a| unsafe { gstxfp_(a.integer(), a.among(0, 3)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSCHXP", call: |a| unsafe { gschxp_(a.real()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSCHSP", call: |a| unsafe { gschsp_(a.real()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSTXCI", call: |a| unsafe { gstxci_(a.integer()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSCHH", call: |a| unsafe { gschh_(a.real()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSCHUP", call: |a| unsafe { gschup_(a.real(), a.real()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSTXP", call: |a| unsafe { gstxp_(a.among(0, 4)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSTXAL", call: |a| unsafe { gstxal_(a.among(0, 4), a.among(0, 6)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSFAI", call: |a| unsafe { gsfai_(a.integer()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSFAIS", call: |a| unsafe { gsfais_(a.among(0, 4)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSFASI", call: |a| unsafe { gsfasi_(a.integer()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSFACI", call: |a| unsafe { gsfaci_(a.integer()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSPA", call: |a| unsafe { gspa_(a.real(), a.real()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSPARF", call: |a| unsafe { gsparf_(a.real(), a.real()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSASF", call: |a| unsafe { gsasf_(a.integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSPKID", call: |a| unsafe { gspkid_(a.integer()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSPLR", call: |a| unsafe { gsplr_(a.among(1, 7), a.integer(), a.integer(), a.real(), a.integer()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSPMR", call: |a| unsafe { gspmr_(a.among(1, 7), a.integer(), a.integer(), a.real(), a.integer()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSTXR", call: |a| unsafe { gstxr_(a.among(1, 7), a.integer(), a.integer(), a.among(0, 3), a.real(), a.real(), a.integer()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSFAR", call: |a| unsafe { gsfar_(a.among(1, 7), a.integer(), a.among(0, 4), a.integer(), a.integer()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSPAR", call: |a| unsafe { gspar_(a.among(1, 7), a.count(), a.count(), a.count(), a.count(), a.count(), a.count(), a.count(), a.integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSCR", call: |a| unsafe { gscr_(a.among(1, 7), a.integer(), a.real(), a.real(), a.real()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSWN", call: |a| unsafe { gswn_(a.integer(), a.real(), a.real(), a.real(), a.real()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSVP", call: |a| unsafe { gsvp_(a.integer(), a.real(), a.real(), a.real(), a.real()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSVPIP", call: |a| unsafe { gsvpip_(a.integer(), a.integer(), a.among(0, 2)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSELNT", call: |a| unsafe { gselnt_(a.integer()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSCLIP", call: |a| unsafe { gsclip_(a.among(0, 2)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSWKWN", call: |a| unsafe { gswkwn_(a.among(1, 7), a.real(), a.real(), a.real(), a.real()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSWKVP", call: |a| unsafe { gswkvp_(a.among(1, 7), a.real(), a.real(), a.real(), a.real()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GCRSG", call: |a| unsafe { gcrsg_(a.among(1, 4)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GCLSG", call: |_| unsafe { gclsg_() } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GRENSG", call: |a| unsafe { grensg_(a.among(1, 4), a.among(1, 4)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GDSG", call: |a| unsafe { gdsg_(a.among(1, 4)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GDSGWK", call: |a| unsafe { gdsgwk_(a.among(1, 7), a.among(1, 4)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GASGWK", call: |a| unsafe { gasgwk_(a.among(1, 7), a.among(1, 4)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GCSGWK", call: |a| unsafe { gcsgwk_(a.among(1, 7), a.among(1, 4)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GINSG", call: |a| unsafe { ginsg_(a.among(1, 4), a.reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSSGT", call: |a| unsafe { gssgt_(a.among(1, 4), a.reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSVIS", call: |a| unsafe { gsvis_(a.among(1, 4), a.among(0, 2)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSHLIT", call: |a| unsafe { gshlit_(a.among(1, 4), a.among(0, 2)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSSGP", call: |a| unsafe { gssgp_(a.among(1, 4), a.real()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSDTEC", call: |a| unsafe { gsdtec_(a.among(1, 4), a.among(0, 2)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GINLC", call: |a| unsafe { ginlc_(a.among(1, 7), a.among(1, 2), a.count(), a.real(), a.real(), a.integer(), a.real(), a.real(), a.real(), a.real(), a.count(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GINSK", call: |a| unsafe { ginsk_(a.among(1, 7), a.among(1, 2), a.count(), a.count(), a.reals(), a.reals(), a.integer(), a.real(), a.real(), a.real(), a.real(), a.count(), a.count(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GINVL", call: |a| unsafe { ginvl_(a.among(1, 7), a.among(1, 2), a.real(), a.integer(), a.real(), a.real(), a.real(), a.real(), a.real(), a.real(), a.count(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GINCH", call: |a| unsafe { ginch_(a.among(1, 7), a.among(1, 2), a.among(0, 3), a.count(), a.integer(), a.real(), a.real(), a.real(), a.real(), a.count(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GINPK", call: |a| unsafe { ginpk_(a.among(1, 7), a.among(1, 2), a.among(0, 3), a.among(1, 4), a.count(), a.integer(), a.real(), a.real(), a.real(), a.real(), a.count(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GINST", call: |a| unsafe { ginst_(a.among(1, 7), a.among(1, 2), a.count(), a.characters(), a.integer(), a.real(), a.real(), a.real(), a.real(), a.count(), a.count(), a.count(), a.record(), Arguments::LENGTH, Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GINSTS", call: |a| unsafe { ginsts_(a.among(1, 7), a.among(1, 2), a.count(), a.characters(), a.integer(), a.real(), a.real(), a.real(), a.real(), a.count(), a.count(), a.count(), a.record(), Arguments::LENGTH, Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSLCM", call: |a| unsafe { gslcm_(a.among(1, 7), a.among(1, 2), a.among(0, 3), a.among(0, 2)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSSKM", call: |a| unsafe { gsskm_(a.among(1, 7), a.among(1, 2), a.among(0, 3), a.among(0, 2)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSVLM", call: |a| unsafe { gsvlm_(a.among(1, 7), a.among(1, 2), a.among(0, 3), a.among(0, 2)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSCHM", call: |a| unsafe { gschm_(a.among(1, 7), a.among(1, 2), a.among(0, 3), a.among(0, 2)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSPKM", call: |a| unsafe { gspkm_(a.among(1, 7), a.among(1, 2), a.among(0, 3), a.among(0, 2)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSSTM", call: |a| unsafe { gsstm_(a.among(1, 7), a.among(1, 2), a.among(0, 3), a.among(0, 2)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GRQLC", call: |a| unsafe { grqlc_(a.among(1, 7), a.among(1, 2), a.output_integers(), a.output_integers(), a.output_reals(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GRQSK", call: |a| unsafe { grqsk_(a.among(1, 7), a.among(1, 2), a.count(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GRQVL", call: |a| unsafe { grqvl_(a.among(1, 7), a.among(1, 2), a.output_integers(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GRQCH", call: |a| unsafe { grqch_(a.among(1, 7), a.among(1, 2), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GRQPK", call: |a| unsafe { grqpk_(a.among(1, 7), a.among(1, 2), a.output_integers(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GRQST", call: |a| unsafe { grqst_(a.among(1, 7), a.among(1, 2), a.output_integers(), a.output_integers(), a.output_characters(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GRQSTS", call: |a| unsafe { grqsts_(a.among(1, 7), a.among(1, 2), a.output_integers(), a.output_integers(), a.output_characters(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSMLC", call: |a| unsafe { gsmlc_(a.among(1, 7), a.among(1, 2), a.output_integers(), a.output_reals(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSMSK", call: |a| unsafe { gsmsk_(a.among(1, 7), a.among(1, 2), a.count(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSMVL", call: |a| unsafe { gsmvl_(a.among(1, 7), a.among(1, 2), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSMCH", call: |a| unsafe { gsmch_(a.among(1, 7), a.among(1, 2), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSMPK", call: |a| unsafe { gsmpk_(a.among(1, 7), a.among(1, 2), a.output_integers(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSMST", call: |a| unsafe { gsmst_(a.among(1, 7), a.among(1, 2), a.output_integers(), a.output_characters(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GSMSTS", call: |a| unsafe { gsmsts_(a.among(1, 7), a.among(1, 2), a.output_integers(), a.output_characters(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GWAIT", call: |a| unsafe { gwait_(a.timeout(), a.output_integers(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GFLUSH", call: |a| unsafe { gflush_(a.among(1, 7), a.among(0, 7), a.among(1, 2)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GGTLC", call: |a| unsafe { ggtlc_(a.output_integers(), a.output_reals(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GGTSK", call: |a| unsafe { ggtsk_(a.count(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GGTVL", call: |a| unsafe { ggtvl_(a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GGTCH", call: |a| unsafe { ggtch_(a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GGTPK", call: |a| unsafe { ggtpk_(a.output_integers(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GGTST", call: |a| unsafe { ggtst_(a.output_integers(), a.output_characters(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GGTSTS", call: |a| unsafe { ggtsts_(a.output_integers(), a.output_characters(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GWITM", call: |a| unsafe { gwitm_(a.among(1, 7), a.kept(0), a.kept(1), a.count(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GGTITM", call: |a| unsafe { ggtitm_(a.among(1, 7), a.kept(0), a.kept(1)) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GRDITM", call: |a| unsafe { grditm_(a.among(1, 7), a.count(), a.count(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GIITM", call: |a| unsafe { giitm_(a.kept(0), a.kept(1), a.count(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQOPS", call: |a| unsafe { gqops_(a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQLVKS", call: |a| unsafe { gqlvks_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQEWK", call: |a| unsafe { gqewk_(a.integer(), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQWKM", call: |a| unsafe { gqwkm_(a.indicator(), a.output_integers(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQMNTN", call: |a| unsafe { gqmntn_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQOPWK", call: |a| unsafe { gqopwk_(a.integer(), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQACWK", call: |a| unsafe { gqacwk_(a.integer(), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPLI", call: |a| unsafe { gqpli_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPMI", call: |a| unsafe { gqpmi_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQTXI", call: |a| unsafe { gqtxi_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQCHH", call: |a| unsafe { gqchh_(a.indicator(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQCHUP", call: |a| unsafe { gqchup_(a.indicator(), a.output_reals(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQCHW", call: |a| unsafe { gqchw_(a.indicator(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQCHB", call: |a| unsafe { gqchb_(a.indicator(), a.output_reals(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQTXP", call: |a| unsafe { gqtxp_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQTXAL", call: |a| unsafe { gqtxal_(a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQFAI", call: |a| unsafe { gqfai_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPA", call: |a| unsafe { gqpa_(a.indicator(), a.output_reals(), a.output_reals(), a.output_reals(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPARF", call: |a| unsafe { gqparf_(a.indicator(), a.output_reals(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPKID", call: |a| unsafe { gqpkid_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQLN", call: |a| unsafe { gqln_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQLWSC", call: |a| unsafe { gqlwsc_(a.indicator(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPLCI", call: |a| unsafe { gqplci_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQMK", call: |a| unsafe { gqmk_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQMKSC", call: |a| unsafe { gqmksc_(a.indicator(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPMCI", call: |a| unsafe { gqpmci_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQTXFP", call: |a| unsafe { gqtxfp_(a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQCHXP", call: |a| unsafe { gqchxp_(a.indicator(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQCHSP", call: |a| unsafe { gqchsp_(a.indicator(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQTXCI", call: |a| unsafe { gqtxci_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQFAIS", call: |a| unsafe { gqfais_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQFASI", call: |a| unsafe { gqfasi_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQFACI", call: |a| unsafe { gqfaci_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQASF", call: |a| unsafe { gqasf_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQCNTN", call: |a| unsafe { gqcntn_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQENTN", call: |a| unsafe { gqentn_(a.integer(), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQNT", call: |a| unsafe { gqnt_(a.count(), a.indicator(), a.output_reals(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQCLIP", call: |a| unsafe { gqclip_(a.indicator(), a.output_integers(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQOPSG", call: |a| unsafe { gqopsg_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQSGUS", call: |a| unsafe { gqsgus_(a.integer(), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQSIM", call: |a| unsafe { gqsim_(a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQWKC", call: |a| unsafe { gqwkc_(a.among(1, 7), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQWKS", call: |a| unsafe { gqwks_(a.among(1, 7), a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQWKDU", call: |a| unsafe { gqwkdu_(a.among(1, 7), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQEPLI", call: |a| unsafe { gqepli_(a.among(1, 7), a.integer(), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPLR", call: |a| unsafe { gqplr_(a.among(1, 7), a.integer(), a.among(0, 2), a.indicator(), a.output_integers(), a.output_reals(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQEPMI", call: |a| unsafe { gqepmi_(a.among(1, 7), a.integer(), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPMR", call: |a| unsafe { gqpmr_(a.among(1, 7), a.integer(), a.among(0, 2), a.indicator(), a.output_integers(), a.output_reals(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQETXI", call: |a| unsafe { gqetxi_(a.among(1, 7), a.integer(), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQTXR", call: |a| unsafe { gqtxr_(a.among(1, 7), a.integer(), a.among(0, 2), a.indicator(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_reals(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQTXX", call: |a| unsafe { gqtxx_(a.among(1, 7), a.real(), a.real(), a.characters(), a.indicator(), a.output_reals(), a.output_reals(), a.output_reals(), a.output_reals(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQTXXS", call: |a| unsafe { gqtxxs_(a.among(1, 7), a.real(), a.real(), a.count(), a.characters(), a.indicator(), a.output_reals(), a.output_reals(), a.output_reals(), a.output_reals(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQEFAI", call: |a| unsafe { gqefai_(a.among(1, 7), a.integer(), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQFAR", call: |a| unsafe { gqfar_(a.among(1, 7), a.integer(), a.among(0, 2), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQEPAI", call: |a| unsafe { gqepai_(a.among(1, 7), a.integer(), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPAR", call: |a| unsafe { gqpar_(a.among(1, 7), a.count(), a.among(0, 2), a.count(), a.count(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQECI", call: |a| unsafe { gqeci_(a.among(1, 7), a.integer(), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQCR", call: |a| unsafe { gqcr_(a.among(1, 7), a.integer(), a.among(0, 2), a.indicator(), a.output_reals(), a.output_reals(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQWKT", call: |a| unsafe { gqwkt_(a.among(1, 7), a.indicator(), a.output_integers(), a.output_reals(), a.output_reals(), a.output_reals(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQSGWK", call: |a| unsafe { gqsgwk_(a.among(1, 7), a.integer(), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQLCS", call: |a| unsafe { gqlcs_(a.among(1, 7), a.among(1, 2), a.among(0, 2), a.count(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_reals(), a.output_integers(), a.output_reals(), a.output_integers(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQSKS", call: |a| unsafe { gqsks_(a.among(1, 7), a.among(1, 2), a.among(0, 2), a.count(), a.count(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_reals(), a.output_integers(), a.output_reals(), a.output_integers(), a.output_integers(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQVLS", call: |a| unsafe { gqvls_(a.among(1, 7), a.among(1, 2), a.count(), a.indicator(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_integers(), a.output_reals(), a.output_reals(), a.output_reals(), a.output_integers(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQCHS", call: |a| unsafe { gqchs_(a.among(1, 7), a.among(1, 2), a.count(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_integers(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPKS", call: |a| unsafe { gqpks_(a.among(1, 7), a.among(1, 2), a.among(0, 2), a.count(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_integers(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQSTS", call: |a| unsafe { gqsts_(a.among(1, 7), a.among(1, 2), a.count(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_characters(), a.output_integers(), a.output_reals(), a.output_integers(), a.output_integers(), a.output_integers(), a.record(), Arguments::LENGTH, Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQSTSS", call: |a| unsafe { gqstss_(a.among(1, 7), a.among(1, 2), a.count(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_characters(), a.output_integers(), a.output_reals(), a.output_integers(), a.output_integers(), a.output_integers(), a.record(), Arguments::LENGTH, Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQWKCA", call: |a| unsafe { gqwkca_(a.workstation_type(), a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQWKCL", call: |a| unsafe { gqwkcl_(a.workstation_type(), a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQDSP", call: |a| unsafe { gqdsp_(a.workstation_type(), a.indicator(), a.output_integers(), a.output_reals(), a.output_reals(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQDWKA", call: |a| unsafe { gqdwka_(a.workstation_type(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQDDS", call: |a| unsafe { gqdds_(a.workstation_type(), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPLF", call: |a| unsafe { gqplf_(a.workstation_type(), a.integer(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_reals(), a.output_reals(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPPLR", call: |a| unsafe { gqpplr_(a.workstation_type(), a.integer(), a.indicator(), a.output_integers(), a.output_reals(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPMF", call: |a| unsafe { gqpmf_(a.workstation_type(), a.integer(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_reals(), a.output_reals(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPPMR", call: |a| unsafe { gqppmr_(a.workstation_type(), a.integer(), a.indicator(), a.output_integers(), a.output_reals(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQTXF", call: |a| unsafe { gqtxf_(a.workstation_type(), a.integer(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_reals(), a.output_integers(), a.output_reals(), a.output_reals(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPTXR", call: |a| unsafe { gqptxr_(a.workstation_type(), a.integer(), a.indicator(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_reals(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQFAF", call: |a| unsafe { gqfaf_(a.workstation_type(), a.integer(), a.integer(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPFAR", call: |a| unsafe { gqpfar_(a.workstation_type(), a.integer(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPAF", call: |a| unsafe { gqpaf_(a.workstation_type(), a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPPAR", call: |a| unsafe { gqppar_(a.workstation_type(), a.count(), a.count(), a.count(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQCF", call: |a| unsafe { gqcf_(a.workstation_type(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPCR", call: |a| unsafe { gqpcr_(a.workstation_type(), a.integer(), a.indicator(), a.output_reals(), a.output_reals(), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQEGDP", call: |a| unsafe { gqegdp_(a.workstation_type(), a.integer(), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQGDP", call: |a| unsafe { gqgdp_(a.workstation_type(), a.count(), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQLWK", call: |a| unsafe { gqlwk_(a.workstation_type(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQSGP", call: |a| unsafe { gqsgp_(a.workstation_type(), a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQDSGA", call: |a| unsafe { gqdsga_(a.workstation_type(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQLI", call: |a| unsafe { gqli_(a.workstation_type(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQDLC", call: |a| unsafe { gqdlc_(a.workstation_type(), a.among(1, 2), a.count(), a.count(), a.indicator(), a.output_reals(), a.output_reals(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_integers(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQDSK", call: |a| unsafe { gqdsk_(a.workstation_type(), a.among(1, 2), a.count(), a.count(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_integers(), a.output_integers(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQDVL", call: |a| unsafe { gqdvl_(a.workstation_type(), a.among(1, 2), a.count(), a.count(), a.indicator(), a.output_reals(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_reals(), a.output_reals(), a.output_integers(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQDCH", call: |a| unsafe { gqdch_(a.workstation_type(), a.among(1, 2), a.count(), a.count(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_integers(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQDPK", call: |a| unsafe { gqdpk_(a.workstation_type(), a.among(1, 2), a.count(), a.count(), a.indicator(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_integers(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQDST", call: |a| unsafe { gqdst_(a.workstation_type(), a.among(1, 2), a.count(), a.count(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_integers(), a.output_integers(), a.record(), Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQASWK", call: |a| unsafe { gqaswk_(a.among(1, 4), a.integer(), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQSGA", call: |a| unsafe { gqsga_(a.among(1, 4), a.indicator(), a.output_reals(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPXAD", call: |a| unsafe { gqpxad_(a.among(1, 7), a.real(), a.real(), a.real(), a.real(), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPXA", call: |a| unsafe { gqpxa_(a.among(1, 7), a.real(), a.real(), a.count(), a.count(), a.count(), a.count(), a.count(), a.count(), a.indicator(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQPX", call: |a| unsafe { gqpx_(a.among(1, 7), a.real(), a.real(), a.indicator(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GQIQOV", call: |a| unsafe { gqiqov_(a.indicator(), a.output_integers(), a.output_integers(), a.output_integers()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GEVTM", call: |a| unsafe { gevtm_(a.real(), a.real(), a.real(), a.real(), a.real(), a.real(), a.real(), a.among(0, 2), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GACTM", call: |a| unsafe { gactm_(a.reals(), a.real(), a.real(), a.real(), a.real(), a.real(), a.real(), a.real(), a.among(0, 2), a.output_reals()) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GECLKS", call: |_| unsafe { geclks_() } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GPREC", call: |a| unsafe { gprec_(a.count(), a.integers(), a.count(), a.reals(), a.count(), a.integers(), a.characters(), a.count(), a.indicator(), a.output_integers(), a.record(), Arguments::LENGTH, Arguments::LENGTH) } },
    // SAFETY: every argument has the type and at least the size that the subroutine asks for.
    Subroutine { name: "GUREC", call: |a| unsafe { gurec_(a.count(), a.record(), a.count(), a.count(), a.count(), a.indicator(), a.output_integers(), a.output_integers(), a.output_integers(), a.output_reals(), a.output_integers(), a.output_integers(), a.output_characters(), Arguments::LENGTH, Arguments::LENGTH) } },
];
