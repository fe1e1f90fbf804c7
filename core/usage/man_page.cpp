#include "core/usage/man_page.h"

#include <QRegularExpression>

namespace usar::usage {

namespace {

/// What roff would take for its own, or print as another character than the one that is meant: a plain "-" is a hyphen,
/// which nobody can copy into a shell.
const QMap<QChar, QString> special{{'\\', "\\e"},  {'-', "\\-"},   {'\'', "\\(aq"}, {'"', "\\(dq"},
                                   {'`', "\\(ga"}, {'^', "\\(ha"}, {'~', "\\(ti"}};

/// The text in ASCII, with all that is special by its name.
QString escaped(const QString& text) {
    QString safe;
    for (const QChar& letter : text) {
        if (letter.unicode() < 0x80)
            safe += special.value(letter, letter);
        else
            safe += "\\[u" + QString::number(letter.unicode(), 16).toUpper().rightJustified(4, '0') + ']';
    }
    return safe;
}

/// A line of text. A dot at its beginning would be a request.
QString line(const QString& text) {
    const QString safe = escaped(text);
    return (safe.startsWith('.') ? "\\&" : "") + safe + '\n';
}

/// True for words that are not typed as they are: FILE..., [MISSION.json, [options].
bool standsForSomething(const QString& word) {
    static const QRegularExpression capitals("^[^a-z-]*[A-Z]");
    return word == "[options]" || capitals.match(word).hasMatch();
}

/// How something is typed: "\fB\-\-seed\fR \fIN\fR" for "--seed N".
QString typed(const QString& text) {
    QStringList words;
    for (const QString& word : text.split(' ')) {
        QStringList alternatives;
        for (const QString& alternative : word.split('|'))
            alternatives << (standsForSomething(alternative) ? "\\fI" : "\\fB") + escaped(alternative) + "\\fR";
        words << alternatives.join('|');
    }
    return words.join(' ') + '\n';
}

QString entries(const QList<std::pair<QString, QString>>& list) {
    QString text;
    for (const auto& [word, meaning] : list)
        text += ".TP\n" + typed(word) + line(meaning);
    return text;
}

QString options(const Verb& verb) {
    QList<std::pair<QString, QString>> list;
    for (const QCommandLineOption& option : verb.options)
        list.emplace_back(spelled(option), meaningOf(option));
    return entries(list);
}

QString paragraphs(const QStringList& texts) {
    QString text;
    for (const QString& paragraph : texts)
        text += ".PP\n" + line(paragraph);
    return text;
}

QString calls(const Program& program) {
    QString text;
    for (const Verb& verb : program.verbs)
        for (const QString& call : verb.calls)
            text += (text.isEmpty() ? "" : ".br\n") + typed(call);
    return text;
}

/// Without the first ".PP", which directly behind a heading would be an empty paragraph.
QString body(const QString& text) {
    return text.startsWith(".PP\n") ? text.mid(4) : text;
}

QString verbs(const Program& program) {
    if (!program.hasVerbs()) {
        const Verb& only = program.verbs.first();
        return ".SH OPTIONS\n" + options(only) + paragraphs(only.notes);
    }
    QString text = ".SH VERBS\n";
    for (const Verb& verb : program.verbs)
        text += ".SS " + escaped(verb.name) + '\n' + body(paragraphs({verb.purpose})) + options(verb) +
                paragraphs(verb.notes);
    return text + ".SH OPTIONS\n" +
           entries({{spelled(helpOption()), "print the help of the program, or after a verb of that verb"},
                    {spelled(versionOption()), versionOption().description()}});
}

QString exitStatus(const Program& program) {
    QString text = ".SH EXIT STATUS\n";
    for (const Verb& verb : program.verbs) {
        if (program.hasVerbs())
            text += ".SS " + escaped(verb.name) + '\n';
        for (const auto& [code, meaning] : verb.exit_codes)
            text += ".TP\n" + typed(QString::number(code)) + line(meaning);
    }
    return text;
}

QString sections(const Program& program) {
    QString text;
    for (const Section& section : program.sections)
        text += ".SH " + escaped(section.title.toUpper()) + '\n' +
                (section.text.isEmpty() ? QString() : line(section.text)) + entries(section.entries);
    return text;
}

QString seeAlso(const Program& program) {
    QStringList lines;
    for (const QString& other : program.see_also)
        lines << ".BR " + escaped(other) + " (1)";
    return lines.isEmpty() ? QString() : ".SH SEE ALSO\n" + lines.join(",\n") + '\n';
}

} // namespace

QByteArray manPage(const Program& program, const QString& version, const QString& date) {
    const QString title = ".TH " + escaped(program.name.toUpper()) + " 1 " + date + " \"USAR Mission Control " +
                          escaped(version) + "\" \"User Commands\"\n";
    return (title + ".SH NAME\n" + escaped(program.name) + " \\- " + escaped(program.title) + '\n' + ".SH SYNOPSIS\n" +
            calls(program) + ".SH DESCRIPTION\n" + body(paragraphs(program.description)) + verbs(program) +
            sections(program) + exitStatus(program) + seeAlso(program))
        .toLatin1();
}

} // namespace usar::usage
