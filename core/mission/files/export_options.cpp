#include "core/mission/files/export_options.h"

#include "core/mission/files/command_line.h"

namespace usar::mission {

namespace {

QList<QCommandLineOption> exportOptions() {
    return {{"formats", "tif,asc and so on (all that RESULT can give and that are not there yet)", "LIST"},
            {"out", "where the files go (the folder of RESULT)", "DIR"},
            usage::helpOption()};
}

} // namespace

Result<ExportOptions> readExportOptions(const QStringList& arguments) {
    const std::string how = "Write usar-mission export RESULT [--formats LIST] [--out DIR]; --help tells more";
    QCommandLineParser parser;
    if (const auto parsed = parseArguments(parser, exportOptions(), arguments.mid(1), how); !parsed)
        return tl::unexpected(parsed.error());
    ExportOptions options;
    if (parser.isSet("formats")) {
        auto formats = readFormatList(parser.value("formats"), "--formats");
        if (!formats)
            return tl::unexpected(formats.error());
        options.formats = *std::move(formats);
    }
    options.folder = parser.value("out");
    const QStringList words = parser.positionalArguments();
    if (words.size() != 1)
        return failure("this is not how to call it", arguments.join(' ').toStdString(), how);
    options.result = words.first();
    return options;
}

usage::Verb exportVerb() {
    return {.name = "export",
            .calls = {"usar-mission export RESULT [options]"},
            .purpose = "Writes the map of a result (its .json or .bil) or of a recording (.usarrec) in other formats.",
            .options = exportOptions(),
            .notes =
                formatNotes() + QStringList{"Nothing is written over a file that exists. The last line of standard "
                                            "output is one JSON object."},
            .exit_codes = {{0, "done"}, {2, "bad use or input"}}};
}

} // namespace usar::mission
