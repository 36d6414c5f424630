//! What GR's library exports for its own drivers and plug-ins. Nobody else calls it; a program that asks whether the names
//! are there finds them. They do nothing, and give 0 or a null pointer.

/// Functions that do nothing.
macro_rules! nothing {
    ($($name:ident)+) => { $(
        /// Does nothing.
        #[unsafe(no_mangle)]
        extern "C" fn $name() -> usize {
            0
        }
    )+ };
}

nothing! {
    GINKS compress_chunkwise2d gks_adjust_cellarray gks_base64 gks_chr_height gks_close_file gks_close_font gks_compress
    gks_dash gks_debug gks_dl_has_one_of_item gks_dl_read_item gks_dl_write_item gks_emul_fillarea gks_emul_polyline
    gks_emul_polymarker gks_emul_text gks_fatal_error gks_filepath gks_fit_ws_viewport gks_function_name gks_get_dash
    gks_get_dash_list gks_get_ws_type gks_init_core gks_input2utf8 gks_inq_dev_xform gks_inq_pattern_array gks_inq_rgb
    gks_iso2utf gks_list_add gks_list_del gks_list_find gks_list_free gks_lookup_afm gks_lookup_font gks_move
    gks_open_file gks_open_font gks_read_file gks_report_error gks_resample gks_resize gks_seg_xform gks_set_chr_xform
    gks_set_dev_xform gks_set_norm_xform gks_set_pattern_array gks_set_rgb gks_symbol2utf gks_utf82latin1
    gks_util_inq_text_extent gks_wiss_dispatch gks_write_file printdl
    gks_drv_mi gks_drv_mo gks_drv_pdf gks_drv_plugin gks_drv_ps gks_drv_socket gks_drv_win gks_drv_wiss
    gks_agg_plugin gks_cairo_plugin gks_gl_plugin gks_gs_plugin gks_gtk_plugin gks_pgf_plugin gks_qt_plugin
    gks_quartz_plugin gks_svg_plugin gks_video_plugin gks_wmf_plugin gks_wx_plugin gks_x11_plugin gks_zmq_plugin
    gks_ft_get_bitmap gks_ft_get_face gks_ft_init gks_ft_inq_text_extent gks_ft_render gks_ft_terminate gks_ft_text
}

/// Variables that nobody sets.
macro_rules! zero {
    ($($name:ident)+) => { $(
        /// A variable, which is 0.
        #[unsafe(no_mangle)]
        #[allow(non_upper_case_globals, reason = "the name that programs know")]
        static $name: usize = 0;
    )+ };
}

zero! { gks_a_error_file gks_a_error_info gks_ft_bearing_x_direction horiAdvance vertAdvance }
