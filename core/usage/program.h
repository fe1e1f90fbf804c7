// The command line of a program as a table: the parser, --help, the man page and the completion are made from it.
#pragma once

#include <optional>
#include <utility>

#include <QCommandLineOption>
#include <QList>
#include <QString>
#include <QStringList>

namespace usar::usage {

/// Something that a program does. Names of values and operands follow one spelling, which the completion reads: words
/// in capitals stand for something (FILE, FOLDER or DIR, RECORDING, MISSION.json: a file that ends so), words in small
/// letters are typed as they are, and | separates alternatives.
struct Verb {
    QString name;      ///< empty: the program has no verbs
    QStringList calls; ///< "usar-mission run MISSION.json [options]"
    QString purpose;   ///< in sentences
    QList<QCommandLineOption> options{};
    QStringList notes{}; ///< paragraphs that come after the options
    QList<std::pair<int, QString>> exit_codes{};
};

/// A part of the man page with entries, such as EXAMPLES.
struct Section {
    QString title;
    QString text{};
    QList<std::pair<QString, QString>> entries{}; ///< a word, and its meaning
    bool in_help = false;                         ///< --help shows it, too
};

struct Program {
    QString name;
    QString title;           ///< "fly robot missions without a window"
    QStringList description; ///< paragraphs
    QList<Verb> verbs;       ///< one without a name, or several
    QList<Section> sections{};
    QStringList see_also{}; ///< other programs

    bool hasVerbs() const { return verbs.size() > 1; }
};

/// The options that every program has.
QCommandLineOption helpOption();
QCommandLineOption versionOption();

/// "--speed", or "-s" for a name of one letter.
QString spelled(const QString& name);
/// "-h, --help", "--speed N|max": all names and the value.
QString spelled(const QCommandLineOption& option);

/// What is said of the option, with its default.
QString meaningOf(const QCommandLineOption& option);

} // namespace usar::usage
