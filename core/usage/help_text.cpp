#include "core/usage/help_text.h"

#include <algorithm>

namespace usar::usage {

namespace {

constexpr qsizetype width = 100;
constexpr qsizetype most_indent = 25; ///< Longer words have their meaning in the next line.

/// The words in lines, all but the first of which are indented. The first begins at column `at`.
QString wrapped(const QString& text, qsizetype indent, qsizetype at) {
    QString lines;
    for (const QString& word : text.split(' ', Qt::SkipEmptyParts)) {
        if (at > indent && at + 1 + word.size() > width) {
            lines += '\n' + QString(indent, ' ');
            at = indent;
        } else if (at > indent) {
            lines += ' ';
            ++at;
        }
        lines += word;
        at += word.size();
    }
    return lines + '\n';
}

QString paragraph(const QString& text) {
    return text.isEmpty() ? QString() : '\n' + wrapped(text, 0, 0);
}

/// "  --seed N    a number", with the meaning from column `indent` on.
QString entry(const QString& word, const QString& meaning, qsizetype indent) {
    QString line = "  " + word;
    if (line.size() + 2 > indent)
        line += '\n' + QString(indent, ' ');
    else
        line = line.leftJustified(indent);
    return line + wrapped(meaning, indent, indent);
}

QString table(const QList<std::pair<QString, QString>>& entries) {
    qsizetype longest = 0;
    for (const auto& [word, meaning] : entries)
        if (const qsizetype size = word.size() + 4; size <= most_indent)
            longest = std::max(longest, size);
    QString text = entries.isEmpty() ? QString() : QString('\n');
    for (const auto& [word, meaning] : entries)
        text += entry(word, meaning, longest > 0 ? longest : most_indent);
    return text;
}

QString optionTable(const QList<QCommandLineOption>& options) {
    QList<std::pair<QString, QString>> entries;
    for (const QCommandLineOption& option : options)
        entries.emplace_back(spelled(option), meaningOf(option));
    return table(entries);
}

QString exitCodes(const Verb& verb) {
    QStringList codes;
    for (const auto& [code, meaning] : verb.exit_codes)
        codes << QString::number(code) + ": " + meaning;
    return codes.isEmpty() ? QString() : paragraph("Exit code " + codes.join("; ") + '.');
}

} // namespace

QString helpText(const Verb& verb) {
    QString text = verb.calls.join('\n') + '\n' + paragraph(verb.purpose) + optionTable(verb.options);
    for (const QString& note : verb.notes)
        text += paragraph(note);
    return text + exitCodes(verb);
}

QString helpText(const Program& program) {
    QString text;
    if (program.hasVerbs()) {
        for (const Verb& verb : program.verbs)
            text += verb.calls.join('\n') + '\n' + "    " + wrapped(verb.purpose, 4, 4) + '\n';
        text += "An option of a verb is explained by " + program.name + " VERB --help, all of them by man " +
                program.name + ".\n" + optionTable({helpOption(), versionOption()});
    } else {
        text = helpText(program.verbs.first());
    }
    for (const Section& section : program.sections)
        if (section.in_help)
            text += '\n' + section.title + '\n' + paragraph(section.text) + table(section.entries);
    return text;
}

std::optional<QString> answerToHelp(const Program& program, const QStringList& arguments) {
    const QStringList options = arguments.mid(0, arguments.indexOf("--"));
    if (!options.contains("--help") && !options.contains("-h"))
        return std::nullopt;
    for (const Verb& verb : program.verbs)
        if (program.hasVerbs() && verb.name == arguments.first())
            return helpText(verb);
    return helpText(program);
}

} // namespace usar::usage
