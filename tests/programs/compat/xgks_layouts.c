/* Says how large the types of XGKS are and where their members lie, the same for every header that has them. */
#include <xgks.h>

#include <stddef.h>

#define SIZE(type) printf(#type " %zu\n", sizeof(type))
#define AT(type, member) printf(#type "." #member " %zu\n", offsetof(type, member))
#define IS(value) printf(#value " %d\n", (int) (value))

static void basic(void)
{
    SIZE(Gint); SIZE(Glong); SIZE(Gchar); SIZE(Gfloat); SIZE(Gasfs);
    SIZE(Gintlist); AT(Gintlist, integers);
    SIZE(Gstrlist); AT(Gstrlist, strings);
    SIZE(Gpoint); AT(Gpoint, y); SIZE(Gipoint); AT(Gipoint, y);
    SIZE(Glimit); AT(Glimit, xmax); AT(Glimit, ymin); AT(Glimit, ymax);
    SIZE(Grect); AT(Grect, ur);
    SIZE(Gcliprec); AT(Gcliprec, rec);
    SIZE(Gcobundl); AT(Gcobundl, green); AT(Gcobundl, blue);
    SIZE(Gcofac); AT(Gcofac, coavail); AT(Gcofac, predefined);
    SIZE(Gdefer); AT(Gdefer, irgmode);
    SIZE(Gdspsize); AT(Gdspsize, device); AT(Gdspsize, raster);
    SIZE(Gextent); AT(Gextent, concat); AT(Gextent, ll); AT(Gextent, lr); AT(Gextent, ul); AT(Gextent, ur);
    SIZE(Gflbundl); AT(Gflbundl, style); AT(Gflbundl, colour);
    SIZE(Gflfac); AT(Gflfac, hatches); AT(Gflfac, predefined);
    SIZE(Ggdpfac); AT(Ggdpfac, attrs);
    SIZE(Ggdplist); AT(Ggdplist, functions); AT(Ggdplist, indices);
    SIZE(Ggdprec); SIZE(Gescin); SIZE(Gescout);
    SIZE(Ggksmit); AT(Ggksmit, length);
    SIZE(Glnbundl); AT(Glnbundl, width); AT(Glnbundl, colour);
    SIZE(Glnfac); AT(Glnfac, widths); AT(Glnfac, nom); AT(Glnfac, max); AT(Glnfac, predefined);
    SIZE(Gmkbundl); AT(Gmkbundl, size); AT(Gmkbundl, colour);
    SIZE(Gmkfac); AT(Gmkfac, sizes); AT(Gmkfac, nom); AT(Gmkfac, max); AT(Gmkfac, predefined);
    SIZE(Gmodseg); AT(Gmodseg, deletion);
    SIZE(Gmodws); AT(Gmodws, wstran);
    SIZE(Gptbundl); AT(Gptbundl, array);
    SIZE(Gpxarray); AT(Gpxarray, array);
    SIZE(Gsegattr); AT(Gsegattr, segtran); AT(Gsegattr, vis); AT(Gsegattr, hilight); AT(Gsegattr, pri);
    AT(Gsegattr, det);
    SIZE(Gtxalign); AT(Gtxalign, ver);
    SIZE(Gtxfp); AT(Gtxfp, prec);
    SIZE(Gtxbundl); AT(Gtxbundl, ch_exp); AT(Gtxbundl, space); AT(Gtxbundl, colour);
    SIZE(Gtxfac); AT(Gtxfac, fp_list); AT(Gtxfac, heights); AT(Gtxfac, max_ht); AT(Gtxfac, expansions);
    AT(Gtxfac, max_ex); AT(Gtxfac, predefined);
    SIZE(Gindattr); AT(Gindattr, mktype); AT(Gindattr, fp); AT(Gindattr, txcolour); AT(Gindattr, flstyle);
    AT(Gindattr, asflist);
    SIZE(Gpriattr); AT(Gpriattr, up); AT(Gpriattr, chwidth); AT(Gpriattr, base); AT(Gpriattr, path);
    AT(Gpriattr, align); AT(Gpriattr, flindex); AT(Gpriattr, widthvec); AT(Gpriattr, prp);
    SIZE(Gwsct); AT(Gwsct, type);
    SIZE(Gwsdus); AT(Gwsdus, dspsurf); AT(Gwsdus, irgmode); AT(Gwsdus, nframe);
    SIZE(Gwsmax); AT(Gwsmax, active); AT(Gwsmax, assoc);
    SIZE(Gwstables); AT(Gwstables, pat); AT(Gwstables, colour);
    SIZE(Gwstran); AT(Gwstran, v);
    SIZE(Gwsti); AT(Gwsti, request); AT(Gwsti, current);
}

static void input(void)
{
    SIZE(Gloc); AT(Gloc, position); SIZE(Gqloc); AT(Gqloc, loc);
    SIZE(Glnattr); AT(Glnattr, line); AT(Glnattr, bundl);
    SIZE(Gmkattr); AT(Gmkattr, mark); AT(Gmkattr, bundl);
    SIZE(Gtxattr); AT(Gtxattr, text); AT(Gtxattr, bundl);
    SIZE(Gflattr); AT(Gflattr, fill); AT(Gflattr, bundl);
    SIZE(Glocrec); AT(Glocrec, pet4.ln); AT(Glocrec, pet4.data); AT(Glocrec, pet5.acf); AT(Glocrec, pet5.attr);
    AT(Glocrec, pet5.data); AT(Glocrec, pet6);
    SIZE(Glocst); AT(Glocst, esw); AT(Glocst, loc); AT(Glocst, pet); AT(Glocst, e_area); AT(Glocst, record);
    SIZE(Gdefloc); AT(Gdefloc, pets); AT(Gdefloc, e_area); AT(Gdefloc, record);
    SIZE(Gstroke); AT(Gstroke, n_points); AT(Gstroke, points); SIZE(Gqstroke); AT(Gqstroke, stroke);
    SIZE(Gstrokerec); AT(Gstrokerec, pet1.editpos); AT(Gstrokerec, pet1.interval); AT(Gstrokerec, pet1.time);
    AT(Gstrokerec, pet1.data); AT(Gstrokerec, pet2.data); AT(Gstrokerec, pet3.acf); AT(Gstrokerec, pet3.mk);
    AT(Gstrokerec, pet3.data); AT(Gstrokerec, pet4.ln); AT(Gstrokerec, pet4.data);
    SIZE(Gstrokest); AT(Gstrokest, stroke); AT(Gstrokest, pet); AT(Gstrokest, e_area); AT(Gstrokest, record);
    SIZE(Gdefstroke); AT(Gdefstroke, pets); AT(Gdefstroke, e_area); AT(Gdefstroke, record);
    SIZE(Gqval); AT(Gqval, val);
    SIZE(Gvalrec); AT(Gvalrec, pet1.high); AT(Gvalrec, pet1.data); AT(Gvalrec, pet3.data);
    SIZE(Gvalst); AT(Gvalst, val); AT(Gvalst, pet); AT(Gvalst, e_area); AT(Gvalst, record);
    SIZE(Gdefval); AT(Gdefval, pets); AT(Gdefval, e_area); AT(Gdefval, record);
    SIZE(Gchoice); AT(Gchoice, choice);
    SIZE(Gchoicerec); AT(Gchoicerec, pet2.enable); AT(Gchoicerec, pet2.data); AT(Gchoicerec, pet3.strings);
    AT(Gchoicerec, pet4.strings); AT(Gchoicerec, pet5.number); AT(Gchoicerec, pet5.pickids);
    AT(Gchoicerec, pet5.data);
    SIZE(Gchoicest); AT(Gchoicest, choice); AT(Gchoicest, pet); AT(Gchoicest, e_area); AT(Gchoicest, record);
    SIZE(Gdefchoice); AT(Gdefchoice, pets); AT(Gdefchoice, e_area); AT(Gdefchoice, record);
    SIZE(Gpick); AT(Gpick, seg); AT(Gpick, pickid); SIZE(Gpickrec); AT(Gpickrec, pet3.data);
    SIZE(Gpickst); AT(Gpickst, pick); AT(Gpickst, pet); AT(Gpickst, e_area); AT(Gpickst, record);
    SIZE(Gdefpick); AT(Gdefpick, e_area); AT(Gdefpick, record);
    SIZE(Gqstring); AT(Gqstring, string);
    SIZE(Gstringrec); AT(Gstringrec, pet1.position); AT(Gstringrec, pet1.data);
    SIZE(Gstringst); AT(Gstringst, string); AT(Gstringst, pet); AT(Gstringst, e_area); AT(Gstringst, record);
    SIZE(Gdefstring); AT(Gdefstring, pets); AT(Gdefstring, e_area); AT(Gdefstring, record);
    SIZE(Gevent); AT(Gevent, dev); AT(Gevent, class);
    SIZE(Gqueue); AT(Gqueue, class); AT(Gqueue, devno);
    SIZE(Gnumdev); AT(Gnumdev, stroke); AT(Gnumdev, valuator); AT(Gnumdev, choice); AT(Gnumdev, pick);
    AT(Gnumdev, string);
}

static void values(void)
{
    IS(GSPECIFIED); IS(GINDIVIDUAL); IS(GFILLAREA); IS(GC_NOCHOICE); IS(GC_NONE); IS(GPRON); IS(GSAMPLE);
    IS(GEVENT); IS(GNOECHO); IS(GNOCLIP); IS(GALWAYS); IS(GMONOCHROME); IS(GPRESENT); IS(GNDC); IS(GBNIG); IS(GBNIL);
    IS(GASTI); IS(GALLOWED); IS(GPF_FILLAREA); IS(GSOLID); IS(GPATTERN); IS(GHATCH); IS(GDC_OTHER); IS(GNOTEMPTY);
    IS(GNCLASS); IS(GLOCATOR); IS(GISTROKE); IS(GVALUATOR); IS(GCHOICE); IS(GPICK); IS(GISTRING); IS(GCHAR);
    IS(GSTROKE); IS(GREALIZED); IS(GNONE); IS(GNOTLAST); IS(GLMA); IS(GL0A); IS(GL2C); IS(GLN_LDASH);
    IS(GLN_DDOTDASH); IS(GLN_SDASH); IS(GLN_SOLID); IS(GLN_DOTDASH); IS(GMK_POINT); IS(GMK_X); IS(GIMM); IS(GYES);
    IS(GGKOP); IS(GSGOP); IS(GP_NOPICK); IS(GP_NONE); IS(GTP_LEFT); IS(GTP_DOWN); IS(GTH_CENTRE); IS(GTH_RIGHT);
    IS(GTV_CAP); IS(GTV_BOTTOM); IS(GPOSTPONE); IS(GDETECTABLE); IS(GHIGHLIGHTED); IS(GINVISIBLE); IS(GMORE);
    IS(GLOWER); IS(GINVALID); IS(GOUTPUT); IS(GOUTIN); IS(GMO); IS(GMI); IS(GRASTER); IS(GACTIVE); IS(GPENDING);
    IS(GRD_X);
    IS(errnull); IS(errgopengks); IS(errgescredrawnotify); IS(errgpolyline); IS(errgsetasf); IS(errgcreateseg);
    IS(errginitloc); IS(errgreqloc); IS(errgawaitevent); IS(errgwritegksm); IS(errgerrorlog); IS(errginqactivews);
    IS(errginqlevelgks); IS(errginqpixel); IS(errginqvalst); IS(errginqwstran);
}

int main(void)
{
    basic();
    input();
    values();
    return 0;
}
