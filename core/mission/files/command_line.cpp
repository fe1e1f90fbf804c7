#include "core/mission/files/command_line.h"

#include <algorithm>

namespace usar::mission {

namespace {

/// "--speed", or "-s" for a name of one letter.
QString spelled(const QString& name) {
    return (name.size() == 1 ? "-" : "--") + name;
}

/// The parser names only unknown options. Its other complaints are sentences for people, perhaps translated, so what
/// else can be wrong is looked for here: only the last argument can lack its value.
Error errorOf(const QCommandLineParser& parser, const QList<QCommandLineOption>& options, const QStringList& arguments,
              const std::string& usage) {
    const std::string how = usage.empty() ? "Ask usar-mission --help how to write it" : usage;
    if (const QStringList unknown = parser.unknownOptionNames(); !unknown.isEmpty())
        return {"there is no such option", spelled(unknown.first()).toStdString(),
                usage.empty() ? "Ask usar-mission --help for them" : usage};
    for (const QCommandLineOption& option : options) {
        const QString name = spelled(option.names().last());
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
                            const QStringList& arguments, const std::string& usage) {
    parser.addOptions(options);
    if (!parser.parse(QStringList{"usar-mission"} + arguments))
        return tl::unexpected(errorOf(parser, options, arguments, usage));
    return {};
}

std::string asWritten(const QCommandLineParser& parser, const QString& option) {
    return "--" + option.toStdString() + " " + parser.value(option).toStdString();
}

} // namespace usar::mission
