// `usar-mission export`: its command line, and what it makes of a result.
#include <QTest>

#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include "core/mission/files/export_options.h"
#include "core/mission/files/result_writer.h"
#include "core/mission/reports/export_verb.h"
#include "core/mission/runs/export_source.h"
#include "core/mission/runs/mission_runner.h"
#include "tests/mission/files/other_programs.h"
#include "tests/mission/files/sample_scan.h"
#include "tests/suite/suite.h"

namespace tst_export_verb {

using namespace usar;
using namespace usar::mission;

namespace {

struct Trial {
    int exit_code = -1;
    QByteArray written;
    std::string complaints;
    QJsonObject summary() const { return QJsonDocument::fromJson(written).object(); }
    QStringList names() const {
        QStringList names;
        for (const auto& file : summary()["files"].toArray())
            names << QFileInfo(file.toString()).fileName();
        return names;
    }
};

Trial verb(const QStringList& arguments) {
    Trial trial;
    QBuffer input, output(&trial.written);
    input.open(QIODevice::ReadOnly);
    output.open(QIODevice::WriteOnly);
    trial.exit_code = runExportVerb(QStringList{"export"} + arguments,
                                    {input, output, [&](const std::string& text) { trial.complaints += text; }});
    return trial;
}

} // namespace

class tst_ExportVerb : public QObject {
    Q_OBJECT
private slots:
    void readsTheCommandLine_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<ExportOptions>("expected");
        const FormatList tif = *readFormatList("tif", {});
        QTest::newRow("plain") << QStringList{"a.json"} << ExportOptions{"a.json", {}, {}};
        QTest::newRow("everything") << QStringList{"--formats", "tif", "a.usarrec", "--out", "d"}
                                    << ExportOptions{"a.usarrec", tif, "d"};
    }

    void readsTheCommandLine() {
        QFETCH(QStringList, arguments);
        QFETCH(ExportOptions, expected);
        const auto options = readExportOptions(QStringList{"export"} + arguments);
        QVERIFY2(options, options ? "" : options.error().text().c_str());
        QVERIFY(*options == expected);
    }

    void onlyItsOwnVerbIsItsBusiness() {
        QVERIFY(isExportVerb("export"));
        for (const char* const verb : {"run", "replay", "lines", "", "--export"})
            QVERIFY(!isExportVerb(verb));
    }

    void theHelpListsTheFormats() {
        const QString notes = exportVerb().notes.join('\n');
        for (const MapFormat& format : mapFormats())
            QVERIFY2(notes.contains(format.title), format.id);
    }

    void aResultIsExportedFromAnyOfItsFiles_data() {
        QTest::addColumn<QString>("suffix");
        for (const char* const suffix : {".json", ".bil", ".hdr"})
            QTest::newRow(suffix) << suffix;
    }

    void aResultIsExportedFromAnyOfItsFiles() {
        QFETCH(QString, suffix);
        QTemporaryDir folder;
        ScanRecord record = sampleScan(40, 0.5);
        record.far_rasters = {{1, 2, 0.5, {9000.25, 50.25}, {7.0f, 8.0f}}};
        const auto saved = writeResults(record, {}, folder.path());
        QVERIFY(saved);
        const Trial trial =
            verb({ending(*saved, "_001" + suffix), "--formats", "tif,asc", "--out", folder.filePath("exports")});
        QVERIFY2(trial.exit_code == Done, trial.complaints.c_str());
        QVERIFY(trial.summary()["success"].toBool());
        const QString stem = "USAR_Scan_tall-test_R1_001";
        QCOMPARE(trial.names(), (QStringList{stem + ".tif", stem + "_far1.tif", stem + ".asc", stem + "_far1.asc"}));
        const auto fresh = exportMap(record, *readFormatList("tif,asc", {}), folder.filePath("fresh"), stem);
        QVERIFY(fresh);
        for (const QString& name : trial.names()) {
            QFile back(folder.filePath("exports/" + name)), first(folder.filePath("fresh/" + name));
            QVERIFY(back.open(QIODevice::ReadOnly) && first.open(QIODevice::ReadOnly));
            QVERIFY2(back.readAll() == first.readAll(), qPrintable(name));
        }
    }

    void withoutFormatsItAddsWhatIsNotThere() {
        QTemporaryDir folder;
        const auto saved = writeResults(sampleScan(20), {}, folder.path());
        QVERIFY(saved);
        const Trial trial = verb({ending(*saved, ".json")});
        QVERIFY2(trial.exit_code == Done, trial.complaints.c_str());
        // The result has .asc already, and no points.
        const QString stem = "USAR_Scan_tall-test_R1_001";
        QCOMPARE(trial.names(), (QStringList{stem + ".tif", stem + ".geojson"}));
        const Trial again = verb({ending(*saved, ".json")});
        QCOMPARE(again.exit_code, int(BadInput));
        QVERIFY2(again.complaints.find("in every format already") != std::string::npos, again.complaints.c_str());
    }

    void refusalsNameTheFileAndTheMend_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("words");
        QTest::newRow("no file") << QStringList{} << "Write usar-mission export RESULT";
        QTest::newRow("two files") << QStringList{"a", "b"} << "Write usar-mission export RESULT";
        QTest::newRow("unknown option") << QStringList{"a", "--format", "tif"} << "--format: there is no such option";
        QTest::newRow("unknown format") << QStringList{"a", "--formats", "shp"} << "--formats shp: there is no format";
        QTest::newRow("not there") << QStringList{"none.json"} << "none.json: there is no such file";
        QTest::newRow("something else") << QStringList{"other.txt"} << "other.txt: this is neither a result nor";
        QTest::newRow("a summary alone") << QStringList{"alone.json"} << "alone.hdr: ";
        QTest::newRow("heights of another program") << QStringList{"foreign.bil"} << "foreign.bil: the raw heights";
        QTest::newRow("heights cut off") << QStringList{"cut.bil"} << "cut.bil: the raw heights are damaged";
        QTest::newRow("no recording") << QStringList{"bad.usarrec"} << "bad.usarrec";
        QTest::newRow("points of a result") << QStringList{"USAR_Scan_tall-test_R1_001.json", "--formats", "tif,las"}
                                            << "las: there are no points, only heights";
        QTest::newRow("the file is there") << QStringList{"USAR_Scan_tall-test_R1_001.json", "--formats", "asc"}
                                           << "USAR_Scan_tall-test_R1_001.asc: there is a file";
    }

    void refusalsNameTheFileAndTheMend() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, words);
        QTemporaryDir folder;
        QVERIFY(writeResults(sampleScan(5), {}, folder.path()));
        const std::string header = mapping::bilHeader(sampleScan(5).raster);
        for (const auto& [name, text] :
             std::initializer_list<std::pair<const char*, std::string>>{{"other.txt", "text"},
                                                                        {"alone.json", "{}"},
                                                                        {"foreign.hdr", "NROWS 2\nNCOLS 2\n"},
                                                                        {"foreign.bil", "1"},
                                                                        {"cut.hdr", header},
                                                                        {"cut.bil", "short"},
                                                                        {"bad.usarrec", "no recording"}}) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text.data(), qint64(text.size())) > 0);
        }
        const QStringList before = QDir(folder.path()).entryList(QDir::Files);
        if (!arguments.isEmpty())
            arguments[0] = folder.filePath(arguments[0]);
        const Trial trial = verb(arguments);
        QCOMPARE(trial.exit_code, int(BadInput));
        QVERIFY2(QString::fromStdString(trial.complaints).contains(words), trial.complaints.c_str());
        QCOMPARE(trial.summary()["reason"].toString().toStdString(), trial.complaints);
        QVERIFY(!trial.summary()["success"].toBool(true));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), before);
    }
};

USAR_TEST(tst_ExportVerb)

} // namespace tst_export_verb

#include "tst_export_verb.moc"
