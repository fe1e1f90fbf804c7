#include "core/mission/files/command_line.h"

#include <algorithm>

#include "core/usage/program.h"

namespace usar::mission {

namespace {

/// The parser names only unknown options. Its other complaints are sentences for people, perhaps translated, so what
/// else can be wrong is looked for here: only the last argument can lack its value.
Error errorOf(const QCommandLineParser& parser, const QList<QCommandLineOption>& options, const QStringList& arguments,
              const std::string& how) {
    if (const QStringList unknown = parser.unknownOptionNames(); !unknown.isEmpty())
        return {"there is no such option", usage::spelled(unknown.first()).toStdString(), how};
    for (const QCommandLineOption& option : options) {
        const QString name = usage::spelled(option.names().last());
        const bool joined =
            std::ranges::any_of(arguments, [&](const QString& argument) { return argument.startsWith(name + '='); });
        if (!option.valueName().isEmpty() && arguments.last() == name)
            return {"the value is missing", name.toStdString(), how};
        if (option.valueName().isEmpty() && joined)
            return {"this option takes no value", name.toStdString(), how};
    }
    return {parser.errorText().toStdString(), arguments.join(' ').toStdString(), how};
}

} // namespace

Result<void> parseArguments(QCommandLineParser& parser, const QList<QCommandLineOption>& options,
                            const QStringList& arguments, const std::string& how) {
    parser.addOptions(options);
    if (!parser.parse(QStringList{"usar-mission"} + arguments))
        return tl::unexpected(errorOf(parser, options, arguments, how));
    return {};
}

std::string asWritten(const QCommandLineParser& parser, const QString& option) {
    return "--" + option.toStdString() + " " + parser.value(option).toStdString();
}

} // namespace usar::mission
