#include <QTest>

#include "core/usage/help_text.h"
#include "tests/suite/suite.h"
#include "tests/usage/small_program.h"

namespace tst_help_text {

using namespace usar::usage;
using namespace usar::usage_tests;

class tst_HelpText : public QObject {
    Q_OBJECT
private slots:
    void aVerbTellsAllOfItself() {
        QCOMPARE(helpText(smallProgram().verbs.first()),
                 "try-it fly MISSION.json [options]\n"
                 "try-it fly --again RECORDING\n"
                 "\n"
                 "Flies.\n"
                 "\n"
                 "  --speed N|max      how fast (1)\n"
                 "  --again RECORDING  fly this again\n"
                 "  --plan PLAN.lap    a plan\n"
                 "  --adjust on|off    whether to adjust\n"
                 "  --out DIR          where results go, with a sentence that is long enough to be wrapped into a\n"
                 "                     second line of the help, and more\n"
                 "  --quiet            say nothing\n"
                 "  -h, --help         print this help\n"
                 "\n"
                 "A note.\n"
                 "\n"
                 "Exit code 0: flown; 1: fallen.\n");
    }

    void aProgramTellsItsVerbs() {
        QCOMPARE(helpText(smallProgram()),
                 "try-it fly MISSION.json [options]\n"
                 "try-it fly --again RECORDING\n"
                 "    Flies.\n"
                 "\n"
                 "try-it tell [--json] FILE...\n"
                 "    Tells.\n"
                 "\n"
                 "An option of a verb is explained by try-it VERB --help, all of them by man try-it.\n"
                 "\n"
                 "  -h, --help     print this help\n"
                 "  -v, --version  print the version\n");
    }

    void onlySomeSectionsBelongToTheHelp() {
        const QString text = helpText(plainProgram());
        QVERIFY2(text.endsWith("\nKinds\n\nThere are:\n\n  a  the first\n"), qPrintable(text));
    }

    void helpIsGivenToWhoAsks_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("first_line"); // empty: no help is wanted
        const QString program = "try-it fly MISSION.json [options]";
        const QString tell = "try-it tell [--json] FILE...";
        QTest::newRow("the program") << QStringList{"--help"} << program;
        QTest::newRow("in short") << QStringList{"-h"} << program;
        QTest::newRow("a verb") << QStringList{"tell", "--help"} << tell;
        QTest::newRow("a verb, last") << QStringList{"tell", "a", "--json", "-h"} << tell;
        QTest::newRow("a verb that is none") << QStringList{"sing", "--help"} << program;
        QTest::newRow("nothing") << QStringList{} << QString();
        QTest::newRow("a call") << QStringList{"tell", "help"} << QString();
        QTest::newRow("a file of this name") << QStringList{"tell", "--", "--help"} << QString();
    }

    void helpIsGivenToWhoAsks() {
        QFETCH(QStringList, arguments);
        const auto help = answerToHelp(smallProgram(), arguments);
        QTEST(help.value_or(QString()).section('\n', 0, 0), "first_line");
    }
};

USAR_TEST(tst_HelpText)

} // namespace tst_help_text

#include "tst_help_text.moc"
