//! The procedures that page descriptions use: PDF's operators by their names, and a few of our own.

/// The prolog, with the comments that enclose it. The page descriptions that follow count in hundredths of a
/// point.
///
/// Beside PDF's names: `r` draws a relative line, `L` as many as it is told, `T` starts a line of characters in a coordinate system,
/// `y` sets its font, `s` shows characters, `k` moves by ten-thousandths of an em, and `I` draws an image
/// whose samples follow in the file. `I` reads up to the end of the samples even where the deflated stream
/// ends earlier.
pub(crate) const PROLOG: &str = "\
%%BeginProlog
%%BeginResource: procset GKS 1.0 0
/GKS 40 dict def GKS begin
/bd{bind def}bind def
/q{gsave}bd/Q{grestore}bd
/m{moveto}bd/l{lineto}bd/r{rlineto}bd/L{{rlineto}repeat}bd/c{curveto}bd/h{closepath}bd
/S{stroke}bd/f{fill}bd/f*{eofill}bd/W{clip}bd/n{newpath}bd
/w{setlinewidth}bd/J{setlinecap}bd/j{setlinejoin}bd/d{setdash}bd
/g{setgray}bd/rg{setrgbcolor}bd
/re{4 2 roll m 1 index 0 r 0 exch r neg 0 r h}bd
/cm{[7 1 roll]concat}bd
/T{q cm 0 0 m}bd/y{setfont}bd/s{show}bd/k{.0001 mul 0 rmoveto}bd
/I{/dc exch def/ht exch def/wd exch def
/as currentfile/ASCII85Decode filter def
<</ImageType 1/Width wd/Height ht/BitsPerComponent 8/Decode dc
/ImageMatrix[wd 0 0 ht neg 0 ht]/DataSource as/FlateDecode filter>>image
as status{as flushfile}if}bd
end
%%EndResource
%%EndProlog
";
