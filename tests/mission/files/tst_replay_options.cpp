#include <QTest>

#include "core/mission/files/replay_options.h"
#include "tests/suite/suite.h"

namespace tst_replay_options {

using namespace usar;
using namespace usar::mission;

class tst_ReplayOptions : public QObject {
    Q_OBJECT
private slots:
    void readsTheCommandLine_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<ReplayOptions>("expected");
        ReplayOptions plain;
        plain.file = "a.usarrec";
        QTest::newRow("a file is enough") << QStringList{"replay", "a.usarrec"} << plain;
        QTest::newRow("full speed is the default") << QStringList{"replay", "a.usarrec", "--speed", "max"} << plain;
        ReplayOptions full = plain;
        full.speed = 0.5;
        full.from = Seconds{1.5};
        full.to = Seconds{90.0};
        QTest::newRow("all options") << QStringList{"replay", "--speed=0.5", "--from", "1.5", "a.usarrec", "--to", "90"}
                                     << full;
        ReplayOptions text = plain;
        text.verb = ReplayVerb::ToText;
        text.output = "-";
        QTest::newRow("to standard output") << QStringList{"recording-to-text", "a.usarrec", "-"} << text;
        text.verb = ReplayVerb::ToRecording;
        text.file = "a.txt";
        text.output = "b.usarrec";
        QTest::newRow("to a recording") << QStringList{"text-to-recording", "a.txt", "b.usarrec"} << text;
        text.verb = ReplayVerb::ToMcap;
        text.file = "a.usarrec";
        text.output = "a.mcap";
        QTest::newRow("to MCAP") << QStringList{"recording-to-mcap", "a.usarrec", "a.mcap"} << text;
    }

    void readsTheCommandLine() {
        QFETCH(QStringList, arguments);
        QFETCH(ReplayOptions, expected);
        const auto options = readReplayOptions(arguments);
        QVERIFY2(options, options ? "" : options.error().text().c_str());
        QVERIFY(*options == expected);
    }

    void rejectsTheRestAndSaysWhere_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("words");
        QTest::newRow("no file") << QStringList{"replay"} << "usar-mission replay FILE";
        QTest::newRow("two files") << QStringList{"replay", "a", "b"} << "usar-mission replay FILE";
        QTest::newRow("no output") << QStringList{"recording-to-text", "a"} << "usar-mission recording-to-text FROM TO";
        QTest::newRow("unknown option") << QStringList{"replay", "a", "--sped", "3"}
                                        << "--sped: there is no such option";
        QTest::newRow("value missing") << QStringList{"replay", "a", "--from"} << "--from: the value is missing";
        QTest::newRow("an option of another verb")
            << QStringList{"recording-to-text", "a", "b", "--from", "3"} << "--from: there is no such option";
        QTest::newRow("too slow") << QStringList{"replay", "a", "--speed", "0.01"}
                                  << "--speed 0.01: the speed is neither";
        QTest::newRow("too fast") << QStringList{"replay", "a", "--speed", "101"} << "from 0.1 to 100";
        QTest::newRow("no number") << QStringList{"replay", "a", "--from", "noon"} << "--from noon: the moment is not";
        QTest::newRow("before the beginning")
            << QStringList{"replay", "a", "--to", "-1"} << "--to -1: the moment is not";
        QTest::newRow("ends before it begins")
            << QStringList{"replay", "a", "--from", "9", "--to", "8"} << "--to 8.0: it ends before it begins";
    }

    void rejectsTheRestAndSaysWhere() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, words);
        const auto options = readReplayOptions(arguments);
        QVERIFY(!options);
        QVERIFY2(QString::fromStdString(options.error().text()).contains(words), options.error().text().c_str());
        QVERIFY(!options.error().mend.empty());
    }

    void onlyItsOwnVerbsAreItsBusiness() {
        for (const char* verb : {"replay", "recording-to-text", "text-to-recording", "recording-to-mcap"})
            QVERIFY(isReplayVerb(verb));
        for (const char* verb : {"run", "lines", "", "--help"})
            QVERIFY(!isReplayVerb(verb));
    }
};

USAR_TEST(tst_ReplayOptions)

} // namespace tst_replay_options

#include "tst_replay_options.moc"
