// Scripts as bash runs them.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/usage/bash_completion.h"
#include "tests/suite/suite.h"
#include "tests/usage/small_program.h"

namespace tst_bash_completion {

using namespace usar::usage;
using namespace usar::usage_tests;

namespace {

void touch(const QString& path) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
}

/// What is offered after these words, the last of which is being typed, in the order of the alphabet.
QStringList offered(const Program& program, const QStringList& words, const QString& folder) {
    QStringList quoted;
    for (const QString& word : words)
        quoted << '\'' + word + '\'';
    const QByteArray script = bashCompletion(program) + "COMP_WORDS=(" + quoted.join(' ').toUtf8() +
                              ")\nCOMP_CWORD=" + QByteArray::number(words.size() - 1) + "\n_" +
                              QByteArray(program.name.toUtf8()).replace('-', '_') +
                              "\n[ ${#COMPREPLY[@]} -eq 0 ] || printf '%s\\n' \"${COMPREPLY[@]}\"\n";
    QStringList lines = outputOf("bash", {"--norc", "-u"}, script, folder).split('\n', Qt::SkipEmptyParts);
    lines.sort();
    return lines;
}

} // namespace

class tst_BashCompletion : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        for (const char* const file : {"a mission.json", "b.json", "flight.usarrec", "my.lap", "note.txt", "hill.sdf"})
            touch(folder_.filePath(file));
        QVERIFY(QDir(folder_.path()).mkdir("maps"));
        QVERIFY(QDir(folder_.path()).mkdir("maps.json"));
    }

    void itOffersWhatFits_data() {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QStringList>("expected");
        const QStringList dirs{"maps", "maps.json"};
        QTest::newRow("verbs") << QStringList{"try-it", ""} << QStringList{"fly", "tell"};
        QTest::newRow("the beginning of a verb") << QStringList{"try-it", "f"} << QStringList{"fly"};
        QTest::newRow("the program's options") << QStringList{"try-it", "--"} << QStringList{"--help", "--version"};
        QTest::newRow("options of a verb")
            << QStringList{"try-it", "fly", "-"}
            << QStringList{"--adjust", "--again", "--help", "--out", "--plan", "--quiet", "--speed"};
        QTest::newRow("options of another") << QStringList{"try-it", "tell", "--"} << QStringList{"--help", "--json"};
        QTest::newRow("the beginning of an option")
            << QStringList{"try-it", "fly", "x.json", "--a"} << QStringList{"--adjust", "--again"};
        QTest::newRow("words of an option") << QStringList{"try-it", "fly", "--adjust", ""} << QStringList{"off", "on"};
        QTest::newRow("its only word") << QStringList{"try-it", "fly", "--speed", ""} << QStringList{"max"};
        QTest::newRow("with an equals sign")
            << QStringList{"try-it", "fly", "--adjust", "="} << QStringList{"off", "on"};
        QTest::newRow("behind an equals sign")
            << QStringList{"try-it", "fly", "--adjust", "=", "of"} << QStringList{"off"};
        QTest::newRow("a plan") << QStringList{"try-it", "fly", "--plan", ""} << dirs + QStringList{"my.lap"};
        QTest::newRow("a folder") << QStringList{"try-it", "fly", "--out", ""} << dirs;
        QTest::newRow("a recording") << QStringList{"try-it", "fly", "--again", "f"} << QStringList{"flight.usarrec"};
        QTest::newRow("a mission, also with a space in its name")
            << QStringList{"try-it", "fly", ""} << QStringList{"a mission.json", "b.json"} + dirs;
        QTest::newRow("any file") << QStringList{"try-it", "tell", "n"} << QStringList{"note.txt"};
        QTest::newRow("the second file") << QStringList{"try-it", "tell", "note.txt", "my"} << QStringList{"my.lap"};
        QTest::newRow("of no verb") << QStringList{"try-it", "sing", ""} << QStringList{};
        QTest::newRow("a program without verbs") << QStringList{"plain", "--k"} << QStringList{"--kind"};
        QTest::newRow("its words") << QStringList{"plain", "--kind", ""} << QStringList{"a", "b"};
        QTest::newRow("its files") << QStringList{"plain", ""} << QStringList{"hill.sdf"} + dirs;
    }

    void itOffersWhatFits() {
        QFETCH(QStringList, words);
        QFETCH(QStringList, expected);
        const Program program = words.first() == "plain" ? plainProgram() : smallProgram();
        QCOMPARE(offered(program, words, folder_.path()), expected);
    }

private:
    QTemporaryDir folder_;
};

USAR_TEST(tst_BashCompletion)

} // namespace tst_bash_completion

#include "tst_bash_completion.moc"
