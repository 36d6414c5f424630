# The complete example programs of NCAR Graphics that Debian ships: where they are, what they are compiled with and what
# they read. For scripts that set `out`, the folder in which the programs stay, and `limit`, the seconds that each may take.

examples=/usr/share/doc/libncarg-dev/examples
tests=/usr/share/ncarg/tests
objects=$(dirname "$(find /usr/lib -name libdashline.o | head -n 1)")
if [ ! -f $examples/agex07.f ]; then
    # Images without documentation: take the examples from the package itself.
    examples=$out/package/usr/share/doc/libncarg-dev/examples
    if [ ! -f "$examples/agex07.f" ]; then
        mkdir -p "$out"
        (cd "$out" && apt-get download -qq libncarg-dev && dpkg-deb -x libncarg-dev_*.deb package)
    fi
fi

# The sources of a program beside its own, by its name.
companions() {
    case $1 in
        cpex0*) echo "$examples/cpexcc.f" ;;
        mpex0* | mpex10 | mpexfi) echo "$examples/mpexcc.f" ;;
        vvex01 | vvex02) echo "$examples/vvexcc.f" ;;
        c_nnex*) echo "$examples/nnplotc.c" ;;
        nnex*) echo "$examples/nnplotf.f" ;;
        ccpcica | ccpcir | ccpcnrc | ccpezct | ccphl | ccpmap | ccpmovi | ccpvp) echo "$examples/tutorial/ggdini.f" ;;
        tconaq | tcnqck) echo "$objects/libdashline.o $objects/libconrcqck.o $objects/libconraq.o" ;;
        tconas | tcnsup) echo "$objects/libdashsupr.o $objects/libconrcspr.o $objects/libconras.o" ;;
        tcnsmt | tdashs) echo "$objects/libdashsmth.o" ;;
        tagupw) echo "$objects/libagupwrtx.o" ;;
    esac
}

# What a program reads from its standard input: a file of data, or the answers to its questions.
input() {
    local data=
    case $1 in
        ccpila | ccpt2d) data=tutorial/ccpila.dat ;;
        ccpils | ccpilt | ccplbdr | ccptitle) data=tutorial/ccpex.dat ;;
        ccpmpxy) data=tutorial/cpmpxy1.dat ;;
        class1) data=tutorial/class1.dat ;;
        agex13) data=agda13.dat ;;
        ffex02 | ffex03 | c_ffex03) data=ffex02.dat ;;
        c_srex01) data=srex01.dat ;;
        cpex14 | cpex16 | fcover | ffex05 | mpexfi | srex01) data=$1.dat ;;
        EzmapDemo | TdpackDemo) printf 'go\nquit\n'; return ;;
    esac
    [ -z "$data" ] || cat "$examples/$data"
}

# Seconds that a program may take: two of them compute for long.
seconds() {
    case $1 in
        ctfite | ctswth) echo $((limit * 5)) ;;
        *) echo "$limit" ;;
    esac
}

libraries="-lNGlluC -lNGllu -lNGmisc2 -lNGmisc -lNGff -lNGmp -lNGcn -lNGmath -lNGgks -lNGc"

compile() {
    local source=$1 name program
    name=$(basename "${source%.*}")
    program=$out/bin/$name
    [ -x "$program" ] && return
    case $source in
        *.f) gfortran -std=legacy -w -fallow-argument-mismatch -o "$program" "$source" $(companions "$name") \
            -Wl,--no-as-needed $libraries ;;
        *.c) gcc -w -std=gnu89 -DNeedFuncProto -I/usr/include/ncarg -I/usr/include -o "$program" "$source" $(companions "$name") \
            -Wl,--no-as-needed $libraries -lm ;;
    esac >"$out/bin/$name.log" 2>&1 || echo "not compiled: $name"
}

# each FUNCTION NAME...: calls the function for each name, for several at a time.
each() {
    local function=$1
    shift
    printf '%s\n' "$@" | xargs -P "${JOBS:-2}" -I{} bash -c "$function {}"
}

sources=$(ls "$examples"/*.f "$examples"/tutorial/*.f "$tests"/*.f "$examples"/*.c "$examples"/tutorial/*.c "$tests"/*.c |
    grep -vE '/(cpexcc|mpexcc|vvexcc|nnplotf|ggdini)\.f$|/nnplotc\.c$')
export -f companions input seconds compile
export examples objects libraries out limit
