#include "core/usage/bash_completion.h"

#include <algorithm>

namespace usar::usage {

namespace {

/// What may stand in a place of the command line.
struct Wanted {
    QStringList words{};    ///< that are typed as they are
    QStringList suffixes{}; ///< of files: ".json"; "": of any file
    bool folders = false;   ///< folders alone, if there are no suffixes

    void take(const Wanted& other) {
        words += other.words;
        suffixes += other.suffixes;
        folders = folders || other.folders;
    }
};

/// By the spelling of the table: "N|max" has the word max, MISSION.json are files that end so.
Wanted wantedBy(QString placeholder) {
    placeholder.remove('[').remove(']').remove("...");
    Wanted wanted;
    for (const QString& one : placeholder.split('|', Qt::SkipEmptyParts)) {
        if (one.startsWith("DIR") || one == "FOLDER")
            wanted.folders = true;
        else if (one == "RECORDING")
            wanted.suffixes << ".usarrec";
        else if (one == "FILE")
            wanted.suffixes << "";
        else if (one.front().isUpper() && one.contains('.'))
            wanted.suffixes << one.mid(one.indexOf('.'));
        else if (one.front().isLower())
            wanted.words << one;
    }
    return wanted;
}

/// The first that has this name.
const QCommandLineOption* optionOf(const Verb& verb, const QString& name) {
    const auto found = std::ranges::find_if(
        verb.options, [&](const QCommandLineOption& option) { return option.names().contains(name); });
    return found == verb.options.end() ? nullptr : &*found;
}

/// What stands in the calls besides the program, the verb and options with their values.
Wanted operandsOf(const Verb& verb) {
    Wanted wanted;
    for (const QString& call : verb.calls) {
        const QStringList words = call.split(' ').mid(verb.name.isEmpty() ? 1 : 2);
        for (qsizetype i = 0; i < words.size(); ++i) {
            const qsizetype dashes = words[i].indexOf("--");
            if (words[i] == "[options]")
                continue;
            if (dashes < 0) {
                wanted.take(wantedBy(words[i]));
                continue;
            }
            const auto* const option = optionOf(verb, words[i].mid(dashes + 2).remove(']'));
            i += option && !option->valueName().isEmpty() ? 1 : 0;
        }
    }
    return wanted;
}

/// One call of the script's function that offers it; nothing where there is nothing to offer.
QString offer(const Wanted& wanted) {
    QStringList calls;
    if (!wanted.words.isEmpty())
        calls << "%FUNCTION%_words '" + wanted.words.join(' ') + "'";
    QStringList suffixes = wanted.suffixes;
    suffixes.removeDuplicates();
    if (suffixes.contains(QString())) // the others are among them
        suffixes = {QString()};
    if (!suffixes.isEmpty())
        calls << "%FUNCTION%_files '" + suffixes.join("' '") + "'";
    else if (wanted.folders)
        calls << "%FUNCTION%_files";
    return calls.isEmpty() ? ":" : calls.join("; ");
}

QStringList optionNames(const QList<QCommandLineOption>& options) {
    QStringList names;
    for (const QCommandLineOption& option : options)
        for (const QString& name : option.names())
            if (name.size() > 1) // one letter is not worth completing
                names << spelled(name);
    return names;
}

/// One case of the script: what is offered where a verb, the word before and the current one are like this.
QString clause(const QString& verb, const QString& words, const Wanted& wanted) {
    return "        '" + verb + "':" + words + ") " + offer(wanted) + " ;;\n";
}

/// The cases of one verb: the values of its options, then its options, then its operands.
QString cases(const Verb& verb) {
    QString text;
    for (const QCommandLineOption& option : verb.options)
        if (!option.valueName().isEmpty())
            text += clause(verb.name, spelled(option.names().last()) + ":*", wantedBy(option.valueName()));
    return text + clause(verb.name, "*:-*", {optionNames(verb.options)}) + clause(verb.name, "*", operandsOf(verb));
}

/// Bash takes "--speed=max" apart into three words, and a function sees the variables of the one that calls it.
const char* const script = R"(# Completion of %PROGRAM% for bash, made from its table of options.
%FUNCTION%_words() { # 'WORD …'
    mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -W "$1" -- "$current")
}
%FUNCTION%_files() { # SUFFIX …: files that end so, and folders
    local suffix
    compopt -o filenames 2>/dev/null
    mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -d -- "$current")
    for suffix; do
        mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(
            compgen -f -X "!*$suffix" -- "$current" |
                while IFS= read -r file; do [ -d "$file" ] || printf '%s\n' "$file"; done
        )
    done
}
%FUNCTION%() {
    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} verb=''
    COMPREPLY=()
    if [ "$current" = '=' ]; then
        current=''
    elif [ "$before" = '=' ] && [ "$COMP_CWORD" -ge 2 ]; then
        before=${COMP_WORDS[COMP_CWORD - 2]}
    fi
%VERB%
    case "$verb:$before:$current" in
%CASES%    esac
}
complete -F %FUNCTION% %PROGRAM%
)";

} // namespace

QByteArray bashCompletion(const Program& program) {
    QString all_cases, verb;
    if (program.hasVerbs()) {
        QStringList names;
        for (const Verb& one : program.verbs)
            names << one.name;
        verb = "    [ \"$COMP_CWORD\" -eq 1 ] || verb=${COMP_WORDS[1]}\n";
        all_cases = clause({}, "*:-*", {optionNames({helpOption(), versionOption()})}) + clause({}, "*", {names});
    }
    for (const Verb& one : program.verbs)
        all_cases += cases(one);
    QString text = script;
    return text.replace("%VERB%\n", verb)
        .replace("%CASES%", all_cases)
        .replace("%FUNCTION%", "_" + QString(program.name).replace('-', '_'))
        .replace("%PROGRAM%", program.name)
        .toUtf8();
}

} // namespace usar::usage
