#include "core/mission/files/export_options.h"

#include "core/mission/files/command_line.h"

namespace usar::mission {

Result<ExportOptions> readExportOptions(const QStringList& arguments) {
    const std::string usage = "Write usar-mission export RESULT [--formats LIST] [--out DIR]; --help tells more";
    QCommandLineParser parser;
    const auto parsed = parseArguments(parser,
                                       {QCommandLineOption("formats", {}, "LIST"), QCommandLineOption("out", {}, "DIR"),
                                        QCommandLineOption(QStringList{"h", "help"})},
                                       arguments.mid(1), usage);
    ExportOptions options;
    options.help = parser.isSet("help");
    if (options.help)
        return options;
    if (!parsed)
        return tl::unexpected(parsed.error());
    if (parser.isSet("formats")) {
        auto formats = readFormatList(parser.value("formats"), "--formats");
        if (!formats)
            return tl::unexpected(formats.error());
        options.formats = *std::move(formats);
    }
    options.folder = parser.value("out");
    const QStringList words = parser.positionalArguments();
    if (words.size() != 1)
        return failure("this is not how to call it", arguments.join(' ').toStdString(), usage);
    options.result = words.first();
    return options;
}

QString exportHelp() {
    return QStringLiteral("\n"
                          "usar-mission export RESULT [options]\n"
                          "\n"
                          "Writes the map of a result (its .json or .bil) or of a recording (.usarrec) in other "
                          "formats.\n"
                          "\n"
                          "  --formats LIST       tif,asc and so on (all that RESULT can give and that are not there "
                          "yet)\n"
                          "  --out DIR            where the files go (the folder of RESULT)\n"
                          "\n"
                          "Formats:\n") +
           formatsHelp(2) +
           QStringLiteral("\n"
                          "Nothing is written over a file that exists. The last line of standard output is one JSON "
                          "object.\n"
                          "Exit code 0: done; 2: bad use or input.\n");
}

} // namespace usar::mission
