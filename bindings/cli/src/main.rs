//! The command `gks`.

use clap::{Args, Parser, Subcommand, ValueEnum};
use gks_cli::bench::measurement::Effort;
use gks_cli::commands::{
    Failure, bench, compile, coverage, demo, doctor, info, install, play, run, workstations,
};
use gks_cli::viewer;
use gks_metafile::ReadOptions;
use gks_pipeline::record::item::Convention;
use gks_workstations::dialect::Dialect;
use std::ffi::OsString;
use std::path::PathBuf;
use std::process::ExitCode;

/// GKS and PHIGS: one program, every device.
#[derive(Parser)]
#[command(name = "gks", version, about)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Draw the demonstration picture on several devices.
    Demo {
        /// The devices, separated by commas: names or numbers of workstation types, or `all`.
        #[arg(long, default_value = "png,svg,pdf,ps,hpgl")]
        on: String,
        /// The folder for the pictures; made if it is not there.
        #[arg(long, default_value = "out")]
        out: PathBuf,
    },
    /// Draw a metafile on a device.
    Play {
        /// The metafile; `-` is the standard input.
        file: String,
        /// The workstation type: its name, its number or an extension.
        #[arg(long)]
        on: Option<String>,
        /// The file to write.
        #[arg(short, long)]
        output: Option<String>,
        /// The pages to draw: 3, 2-5, 2- or -5.
        #[arg(long, default_value = "1-")]
        pages: play::Pages,
        #[command(flatten)]
        reading: Reading,
    },
    /// Show what is in a metafile.
    Info {
        /// The metafile; `-` is the standard input.
        file: String,
        #[command(flatten)]
        reading: Reading,
        /// As JSON.
        #[arg(long)]
        json: bool,
    },
    /// List the workstation types of this installation.
    Workstations {
        /// As JSON.
        #[arg(long)]
        json: bool,
    },
    /// Show which functions of the standards are there, in each language.
    Spec {
        /// As JSON.
        #[arg(long)]
        json: bool,
    },
    /// Compile and link a C program with the library.
    Cc {
        /// Arguments for the C compiler.
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<OsString>,
    },
    /// Compile and link a Fortran program with the library.
    Fc {
        /// Arguments for the Fortran compiler.
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<OsString>,
    },
    /// Put the command, the libraries and the headers into a folder, for use without the sources.
    Install {
        /// The folder, for example /usr/local; made if it is not there.
        prefix: PathBuf,
    },
    /// Run a program that was built for another GKS, unchanged, on any device.
    Run {
        /// The GKS that it was built for; `auto` looks at what it needs.
        #[arg(long, default_value = "auto", value_parser = ["auto", "iso", "ncar", "xgks", "gr"])]
        dialect: String,
        /// The workstation type to draw on: name or number.
        #[arg(long)]
        on: Option<String>,
        /// The file to write; `%d` is the number of the page.
        #[arg(short, long)]
        output: Option<String>,
        /// The program and its arguments, after `--`.
        #[arg(trailing_var_arg = true, allow_hyphen_values = true, required = true)]
        program: Vec<OsString>,
    },
    /// Say which functions of GKS a program, library or object needs, and how to run it here.
    Doctor {
        /// The file, or the name of a program.
        program: PathBuf,
    },
    /// Measure what drawing costs.
    Bench {
        /// The workloads; all if none is named.
        workloads: Vec<String>,
        /// As JSON.
        #[arg(long)]
        json: bool,
        /// Each once, at its smallest size, to see that it works.
        #[arg(long)]
        once: bool,
        /// Measure one workload at one size in this process.
        #[arg(long, value_enum, hide = true, requires_all = ["size", "folder"])]
        measure: Option<Effort>,
        #[arg(long, hide = true)]
        size: Option<usize>,
        #[arg(long, hide = true)]
        folder: Option<PathBuf>,
    },
    /// Show the window of a program; programs start this themselves.
    #[command(hide = true)]
    Viewer,
}

/// How a metafile is read where it does not say.
#[derive(Args)]
struct Reading {
    /// Whose coding of UPDATE and VISIBILITY a metafile of GKS has, if its header does not tell.
    #[arg(long, value_enum)]
    items: Option<Items>,
}

impl Reading {
    fn options(&self) -> ReadOptions {
        ReadOptions { items: self.items.map(Items::convention) }
    }
}

/// Authors of metafiles who code items differently.
#[derive(Copy, Clone, ValueEnum)]
enum Items {
    /// RAL GKS.
    Ral,
    /// XGKS.
    Xgks,
}

impl Items {
    fn convention(self) -> Convention {
        match self {
            Items::Ral => Convention::Ral,
            Items::Xgks => Convention::Xgks,
        }
    }
}

fn main() -> ExitCode {
    let result: Result<ExitCode, Failure> = match Arguments::parse().command {
        Command::Demo { on, out } => demo::run(&on, &out),
        Command::Play { file, on, output, pages, reading } => {
            play::run(&play::Play { file, on, out: output, pages, options: reading.options() })
        }
        Command::Info { file, reading, json } => info::run(&file, &reading.options(), json),
        Command::Workstations { json } => workstations::run(json),
        Command::Spec { json } => coverage::run(json),
        Command::Cc { arguments } => compile::run(compile::Language::C, &arguments),
        Command::Fc { arguments } => compile::run(compile::Language::Fortran, &arguments),
        Command::Install { prefix } => install::run(&prefix),
        Command::Run { dialect, on, output, program } => {
            let wishes = run::Wishes { dialect: Dialect::from_name(&dialect), on, output };
            match program.split_first() {
                Some((program, arguments)) => run::run(&wishes, program, arguments),
                None => Err("no program".into()),
            }
        }
        Command::Doctor { program } => doctor::run(&program),
        Command::Bench {
            workloads, measure: Some(effort), size: Some(size), folder: Some(folder), ..
        } => workloads
            .iter()
            .try_fold(ExitCode::SUCCESS, |_, name| bench::measure(name, size, effort, &folder)),
        Command::Bench { workloads, json, once, .. } => bench::run(&bench::Wish { workloads, json, once }),
        Command::Viewer => viewer::run(),
    };
    result.unwrap_or_else(|failure| {
        eprintln!("gks: {failure}");
        ExitCode::FAILURE
    })
}
