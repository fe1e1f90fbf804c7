// What the programs, their man pages, their completions and the pages of the documentation say of options is the same.
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include "app/cli/behavior_host_program.h"
#include "app/cli/mission_program.h"
#include "core/server/embedded/simulator_settings.h"
#include "core/server/embedded/window_options.h"
#include "tests/suite/suite.h"
#include "tests/usage/small_program.h"

namespace tst_pages_agree {

using namespace usar;
using namespace usar::usage;
using usage_tests::outputOf;

namespace {

const QString source = USAR_SOURCE_DIR;
const QString build = USAR_BINARY_DIR;

QList<Program> programs() {
    return {app::missionProgram(), server::simulatorProgram(), server::windowProgram(), app::behaviorHostProgram()};
}

QString readAll(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// "--speed N|max" and the like, in the order of the alphabet.
QStringList tableOf(const Verb& verb) {
    QStringList options;
    for (const QCommandLineOption& option : verb.options)
        options << spelled(option);
    options.sort();
    return options;
}

/// All that the expression captures, in the order of the alphabet.
QStringList allOf(const char* expression, const QString& text) {
    QStringList found;
    auto matches = QRegularExpression(expression, QRegularExpression::MultilineOption).globalMatch(text);
    while (matches.hasNext())
        found << matches.next().captured(1);
    found.removeDuplicates();
    found.sort();
    return found;
}

QStringList optionsInHelp(const QString& help) {
    return allOf("^  ((?:-\\w, )?--[a-z-]+(?: [^ \n]+)?)(?:  |$)", help);
}

/// Of a man page as HTML: the words with a meaning in the section with this name that are options.
QStringList optionsInManPage(const QString& html, const QString& name) {
    const QString section = html.section(">" + name + "</a>", 1, 1).section("</section>", 0, 0);
    QStringList options;
    static const QRegularExpression term("<dt[^>]*>(.*?)</dt>", QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression tag("<[^>]*>");
    auto terms = term.globalMatch(section);
    while (terms.hasNext())
        if (const QString word = terms.next().captured(1).remove(tag).simplified(); word.startsWith('-'))
            options << word;
    options.sort();
    return options;
}

/// The part below this heading, up to the next one that is no deeper.
QString below(const QString& heading, const QString& page) {
    const qsizetype begin = page.indexOf('\n' + heading + '\n') + 1;
    if (begin == 0)
        return {};
    const QString marks = heading.section(' ', 0, 0);
    const qsizetype end =
        page.indexOf(QRegularExpression(QString("^#{1,%1} ").arg(marks.size()), QRegularExpression::MultilineOption),
                     begin + heading.size());
    return page.mid(begin, end < 0 ? -1 : end - begin);
}

/// Of a page of ours: the options in the first cells of its tables.
QStringList optionsInTables(const QString& page) {
    QStringList cells;
    for (const QString& line : page.split('\n'))
        if (line.startsWith("| `--"))
            cells << QString(line).replace("\\|", "!").section('|', 1, 1).replace('!', '|');
    return allOf("`(--[^`]+)`", cells.join('\n'));
}

/// Options that belong to every verb; the pages say so once.
QStringList withoutCommon(QStringList options) {
    options.removeAll(spelled(helpOption()));
    options.removeAll(spelled(versionOption()));
    return options;
}

/// All words that look like an option.
QStringList namesIn(const QString& text) {
    return allOf("(?:^|[\\s`\"(\\[|])(--[a-z][a-z-]*)", text);
}

/// Of other programs: cmake, app/run, tests/run, make-deb, parallel, irace, ctest.
const QStringList others{"--build",    "--preset",   "--target",        "--install",  "--prefix", "--component",
                         "--headless", "--sshlogin", "--resume-failed", "--scenario", "--joblog"};

} // namespace

class tst_PagesAgree : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void theProgramSaysItsTable_data();
    void theProgramSaysItsTable();
    void theManPageSaysTheSame_data() { theProgramSaysItsTable_data(); }
    void theManPageSaysTheSame();
    void theCompletionOffersTheSame_data() { theProgramSaysItsTable_data(); }
    void theCompletionOffersTheSame();
    void everyCallHasOptionsOfTheTable();
    void aPageHasATableOfAllOptions_data();
    void aPageHasATableOfAllOptions();
    void aPageSpeaksOfEveryOption_data();
    void aPageSpeaksOfEveryOption();
    void theReadmeHasSomeOfTheTable();
    void noPageHasAnOptionThatIsNone();
    void theTestItselfSeesWhatIsMissing();

private:
    const Verb& verb(const QString& row) const { return verbs_.at(row); }

    std::map<QString, Verb> verbs_; ///< by "usar-mission run", "usar-sim"
};

void tst_PagesAgree::initTestCase() {
    for (const Program& program : programs())
        for (const Verb& verb : program.verbs)
            verbs_[(program.name + ' ' + verb.name).trimmed()] = verb;
    QVERIFY(verbs_.size() >= 12);
}

void tst_PagesAgree::theProgramSaysItsTable_data() {
    QTest::addColumn<QString>("call");
    for (const auto& [call, verb] : verbs_)
        QTest::newRow(qPrintable(call)) << call;
}

void tst_PagesAgree::theProgramSaysItsTable() {
    QFETCH(QString, call);
    const QStringList words = call.split(' ');
    const QString help = outputOf(build + "/bin/" + words.first(), words.mid(1) + QStringList{"--help"});
    QCOMPARE(optionsInHelp(help), tableOf(verb(call)));
    QVERIFY(help.startsWith(verb(call).calls.join('\n') + '\n'));
}

void tst_PagesAgree::theManPageSaysTheSame() {
    QFETCH(QString, call);
    const QString path = build + "/share/man/man1/" + call.section(' ', 0, 0) + ".1";
    const QString page = outputOf("mandoc", {"-T", "html", "-O", "fragment", "-W", "warning,stop", path});
    const QString name = call.section(' ', 1);
    QCOMPARE(optionsInManPage(page, name.isEmpty() ? "OPTIONS" : name), tableOf(verb(call)));
    for (const QString heading : {"NAME", "SYNOPSIS", "DESCRIPTION", "EXIT_STATUS", "SEE_ALSO"})
        QVERIFY2(page.contains("id=\"" + heading + '"'), qPrintable(heading));
}

void tst_PagesAgree::theCompletionOffersTheSame() {
    QFETCH(QString, call);
    const QString program = call.section(' ', 0, 0);
    const QString script =
        QString("source '%1'; COMP_WORDS=(%2 --); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _%3; "
                "printf '%s\\n' \"${COMPREPLY[@]}\"")
            .arg(build + "/share/bash-completion/completions/" + program, call, QString(program).replace('-', '_'));
    QStringList offered = outputOf("bash", {"--norc", "-c", script}).split('\n', Qt::SkipEmptyParts);
    offered.sort();
    QStringList names;
    for (const QCommandLineOption& option : verb(call).options)
        names << spelled(option.names().last());
    names.sort();
    QCOMPARE(offered, names);
}

void tst_PagesAgree::everyCallHasOptionsOfTheTable() {
    for (const auto& [name, verb] : verbs_)
        for (const QString& option : namesIn(verb.calls.join('\n')))
            QVERIFY2(tableOf(verb).join('\n').contains(option), qPrintable(name + ' ' + option));
}

void tst_PagesAgree::aPageHasATableOfAllOptions_data() {
    QTest::addColumn<QString>("page");
    QTest::addColumn<QString>("heading");
    QTest::newRow("usar-mission run") << "headless.md"
                                      << "### Options";
    QTest::newRow("usar-mission campaign") << "campaigns.md"
                                           << "## Options";
    QTest::newRow("usar-mission replay") << "headless.md"
                                         << "## `replay`";
    QTest::newRow("usar-sim") << "simulator.md"
                              << "## Options";
    QTest::newRow("mission-control") << "manual.md"
                                     << "## Starting it";
}

void tst_PagesAgree::aPageHasATableOfAllOptions() {
    QFETCH(QString, page);
    QFETCH(QString, heading);
    const QString text = readAll(source + "/resources/docs/" + page);
    QCOMPARE(optionsInTables(below(heading, text)), withoutCommon(tableOf(verb(QTest::currentDataTag()))));
}

void tst_PagesAgree::aPageSpeaksOfEveryOption_data() {
    QTest::addColumn<QString>("page");
    QTest::newRow("usar-mission compare") << "campaigns.md";
    QTest::newRow("usar-mission check-plan") << "headless.md";
    QTest::newRow("usar-mission plan-report") << "headless.md";
}

void tst_PagesAgree::aPageSpeaksOfEveryOption() {
    QFETCH(QString, page);
    const QStringList said = namesIn(readAll(source + "/resources/docs/" + page));
    for (const QString& option : withoutCommon(tableOf(verb(QTest::currentDataTag()))))
        QVERIFY2(said.contains(option.section(' ', 0, 0)), qPrintable(page + " lacks " + option));
}

void tst_PagesAgree::theReadmeHasSomeOfTheTable() {
    const QStringList rows = optionsInTables(below("## Without a window", readAll(source + "/README.md")));
    QVERIFY(rows.size() >= 10);
    for (const QString& row : rows)
        QVERIFY2(tableOf(verb("usar-mission run")).contains(row), qPrintable("README.md has " + row));
}

void tst_PagesAgree::noPageHasAnOptionThatIsNone() {
    QString all;
    for (const auto& [name, verb] : verbs_)
        all += tableOf(verb).join('\n') + '\n';
    const QStringList known = namesIn(all.replace(", ", "\n")) + others;
    QStringList strange;
    for (const QString page : {"README.md", "resources/docs/headless.md", "resources/docs/simulator.md",
                               "resources/docs/manual.md", "resources/docs/campaigns.md", "resources/docs/plans.md"})
        for (const QString& option : namesIn(readAll(source + '/' + page)))
            if (!known.contains(option))
                strange << page + ": " + option;
    QVERIFY2(strange.isEmpty(), qPrintable(strange.join('\n')));
}

void tst_PagesAgree::theTestItselfSeesWhatIsMissing() {
    QCOMPARE(optionsInHelp("  --seed N    a seed\n  -h, --help  help\n  --a-very-long-one THING\n          more\n"
                           "--no option\n"),
             (QStringList{"--a-very-long-one THING", "--seed N", "-h, --help"}));
    QCOMPARE(optionsInManPage("<h2><a>run</a></h2><dt><a><b>--speed</b>\n <i>N</i></a></dt><dt>FILE</dt></section>"
                              "<h2><a>next</a></h2><dt>--other</dt></section>",
                              "run"),
             QStringList{"--speed N"});
    QCOMPARE(optionsInTables("| `--speed N\\|max` | x `--no` |\n| `--save FILE`, `--resume FILE` | |\nand `--other`\n"),
             (QStringList{"--resume FILE", "--save FILE", "--speed N|max"}));
    QCOMPARE(namesIn("x--no `--one` [--two] --three=3 -- ---"), (QStringList{"--one", "--three", "--two"}));
    QCOMPARE(below("## a", "\n## a\nb\n### c\nd\n## e\nf"), QString("## a\nb\n### c\nd\n"));
}

USAR_TEST(tst_PagesAgree)

} // namespace tst_pages_agree

#include "tst_pages_agree.moc"
