// Runs side by side: what their summaries tell, and the dialog that shows it.
#include <algorithm>

#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/bars/result_card.h"
#include "widgets/panels/compare_dialog.h"

namespace tst_run_comparison {

using namespace usar;
using namespace usar::widgets;

namespace {

const QString dash = QStringLiteral("–");

RunFigures good() {
    return {.path = QStringLiteral("/a/S_001.json"),
            .mission = QStringLiteral("Quick scan"),
            .behavior = QStringLiteral("airrobot/cpp"),
            .success = true,
            .coverage_pct = 99.5,
            .duration_s = 520.0,
            .distance_m = 412.0,
            .lowest_m = -2.96,
            .highest_m = 18.37,
            .error_m = 0.44,
            .charges = 0.0,
            .collisions = 0.0};
}

QJsonObject summary() {
    return {{"success", true},
            {"mission", "Quick scan"},
            {"behavior", "airrobot/cpp"},
            {"duration_s", 522.4},
            {"distance_m", 411.6},
            {"coverage_pct", 99.74},
            {"rmse_m", 0.437},
            {"charges", 1},
            {"collisions", QJsonValue::Null},
            {"files", QJsonArray{}},
            {"map", QJsonObject{{"minimum_m", -2.96}, {"maximum_m", 18.37}}}};
}

const ComparedRow& row(const std::vector<ComparedRow>& rows, const QString& name) {
    return *std::ranges::find(rows, name, &ComparedRow::name);
}

} // namespace

class tst_RunComparison : public QObject {
    Q_OBJECT
private slots:
    void aRunIsNamedByItsTitleOrItsFile() {
        RunFigures run = good();
        QCOMPARE(titleOf(run), QString("Quick scan\nS_001"));
        run.title = "POSH, seed 3";
        QCOMPARE(titleOf(run), QString("Quick scan\nPOSH, seed 3"));
        run.mission.clear();
        QCOMPARE(titleOf(run), QString("POSH, seed 3"));
    }

    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void readsWhatAMissionLeaves() {
        const auto run = readRun(write("S_001.json", QJsonDocument(summary()).toJson()));
        QVERIFY2(run, run ? "" : run.error().text().c_str());
        QCOMPARE(run->mission, QStringLiteral("Quick scan"));
        QCOMPARE(run->coverage_pct, std::optional(99.74));
        QCOMPARE(run->highest_m, std::optional(18.37));
        QCOMPARE(run->charges, std::optional(1.0));
        QVERIFY(!run->collisions && run->picture.isEmpty());
    }

    void findsThePictureBesideAFolderThatWasMoved() {
        QJsonObject moved = summary();
        moved["files"] = QJsonArray{"/gone/S_001_picture.png"};
        const QString picture = folder_->filePath("S_001_picture.png");
        QVERIFY(QImage(8, 8, QImage::Format_RGB32).save(picture));
        QCOMPARE(readRun(write("S_001.json", QJsonDocument(moved).toJson()))->picture, picture);
    }

    void namesAGarbledFileAndItsMend_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("words");
        QTest::newRow("cut off") << QByteArray("{\n\"success\": true,\n\"dur")
                                 << QStringLiteral("odd.json: is garbled at line 3. Choose");
        QTest::newRow("empty") << QByteArray() << QStringLiteral("odd.json: is garbled at line 1. Choose");
        QTest::newRow("a mission") << QByteArray(R"({"name": "Quick scan", "area": {}})")
                                   << QStringLiteral("is not the summary of a run");
        QTest::newRow("a list") << QByteArray("[1, 2]") << QStringLiteral("is not the summary of a run");
    }
    void namesAGarbledFileAndItsMend() {
        QFETCH(QByteArray, text);
        QFETCH(QString, words);
        const auto run = readRun(write("odd.json", text));
        QVERIFY(!run);
        const QString told = QString::fromStdString(run.error().text());
        QVERIFY2(told.contains("odd.json") && told.contains(words) && told.contains("Choose a .json"),
                 qPrintable(told));
        QVERIFY(!readRun(folder_->filePath("none.json")));
    }

    void aFigureThatIsMissingOrOfAnotherKindIsADash() {
        QJsonObject odd{{"success", "yes"}, {"duration_s", QJsonValue::Null}, {"coverage_pct", "all"}};
        const auto run = readRun(write("odd.json", QJsonDocument(odd).toJson()));
        QVERIFY(run);
        for (const ComparedRow& one : compared({*run, *run}))
            for (const ComparedCell& cell : one.cells)
                QVERIFY2(cell.value == dash && cell.difference.isEmpty() && !cell.better, qPrintable(one.name));
    }

    void theBetterFigureIsMarked_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<RunFigures>("other");
        QTest::addColumn<QStringList>("told"); // value and difference of the second run
        QTest::addColumn<QList<bool>>("better");
        const auto with = [](auto member, double value) {
            RunFigures run = good();
            run.*member = value;
            return run;
        };
        QTest::newRow("more coverage") << "Coverage" << with(&RunFigures::coverage_pct, 99.9)
                                       << QStringList{"99.9 %", "+0.4 %"} << QList<bool>{false, true};
        QTest::newRow("less coverage") << "Coverage" << with(&RunFigures::coverage_pct, 90.0)
                                       << QStringList{"90.0 %", "−9.5 %"} << QList<bool>{true, false};
        QTest::newRow("longer") << "Time" << with(&RunFigures::duration_s, 590.0)
                                << QStringList{"9 min 50 s", "+1 min 10 s"} << QList<bool>{true, false};
        QTest::newRow("less error") << "Error" << with(&RunFigures::error_m, 0.4) << QStringList{"0.40 m", "−0.04 m"}
                                    << QList<bool>{false, true};
        QTest::newRow("the same as written") << "Error" << with(&RunFigures::error_m, 0.4401)
                                             << QStringList{"0.44 m", "same"} << QList<bool>{false, false};
        QTest::newRow("higher is not better") << "Highest" << with(&RunFigures::highest_m, 20.0)
                                              << QStringList{"20.0 m", "+1.6 m"} << QList<bool>{false, false};
        QTest::newRow("a collision") << "Collisions" << with(&RunFigures::collisions, 1.0) << QStringList{"1", "+1"}
                                     << QList<bool>{true, false};
    }
    void theBetterFigureIsMarked() {
        QFETCH(QString, name);
        QFETCH(RunFigures, other);
        QFETCH(QStringList, told);
        QFETCH(QList<bool>, better);
        const auto rows = compared({good(), other});
        const auto& cells = row(rows, name).cells;
        QCOMPARE((QStringList{cells[1].value, cells[1].difference}), told);
        QCOMPARE((QList<bool>{cells[0].better, cells[1].better}), better);
        QVERIFY(cells[0].difference.isEmpty());
    }

    void theDialogShowsRunsSideBySide() {
        QJsonObject worse = summary();
        worse["coverage_pct"] = 80.0;
        const QString first = write("S_001.json", QJsonDocument(summary()).toJson());
        const QString second = write("S_002.json", QJsonDocument(worse).toJson());
        QVERIFY(QImage(40, 30, QImage::Format_RGB32).save(folder_->filePath("S_002_picture.png")));
        QWidget window;
        compareRuns(&window, first);
        auto* const dialog = window.findChild<CompareDialog*>();
        QVERIFY(dialog && dialog->isVisible() && !dialog->isModal());
        dialog->add(second);
        QTRY_COMPARE(dialog->runs().size(), std::size_t(2));
        compareRuns(&window, second); // Once more is no third.
        dialog->add(write("garbled.json", "{"));
        QTRY_VERIFY(dialog->trouble().contains("garbled.json"));
        const auto* const table = dialog->findChild<QTableWidget*>();
        QCOMPARE(table->columnCount(), 2);
        QCOMPARE(table->item(2, 0)->text(), QStringLiteral("✓ 99.7 %"));
        QCOMPARE(table->item(2, 1)->text(), QStringLiteral("80.0 %  (−19.7 %)"));
        QVERIFY(table->item(2, 0)->data(Qt::AccessibleTextRole).toString().contains("better"));
        QTRY_VERIFY(says(*dialog, "S_001 has no picture")); // New labels are shown a moment later.
        const auto labels = dialog->findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(labels,
                                    [](const QLabel* label) { return !label->pixmap(Qt::ReturnByValue).isNull(); }));
    }

    void aFolderThatNoMissionHasMadeYetIsNoError() {
        QWidget window;
        compareRuns(&window, folder_->filePath("results"));
        auto* const dialog = window.findChild<CompareDialog*>();
        QVERIFY(says(*dialog, "No runs yet"));
        dialog->add(write("S_001.json", QJsonDocument(summary()).toJson()));
        QTRY_COMPARE(dialog->runs().size(), std::size_t(1));
        QCOMPARE(dialog->trouble(), QString());
        QTRY_VERIFY(!says(*dialog, "No runs yet"));
    }

    void aRunIsTakenOutAgain() {
        CompareDialog dialog;
        dialog.add(write("S_001.json", QJsonDocument(summary()).toJson()));
        dialog.add(write("S_002.json", QJsonDocument(summary()).toJson()));
        QTRY_COMPARE(dialog.runs().size(), std::size_t(2));
        QVERIFY(dialog.runs()[0].path.endsWith("S_001.json"));
        dialog.show();
        auto* const remove = button(dialog, "Remove run");
        QVERIFY(!remove->isEnabled());
        dialog.findChild<QTableWidget*>()->setCurrentCell(2, 0);
        QTest::mouseClick(remove, Qt::LeftButton);
        QCOMPARE(dialog.runs().size(), std::size_t(1));
        QVERIFY(dialog.runs()[0].path.endsWith("S_002.json"));
    }

    void theCardOffersToCompareWhatWasWritten() {
        ResultCard card;
        QSignalSpy compare(&card, &ResultCard::compareRequested);
        card.tell({.robot = "R1", .files = {"/scans/S_001.bil", "/scans/S_001.json"}});
        QTest::mouseClick(button(card, "Compare"), Qt::LeftButton);
        QCOMPARE(compare.value(0).value(0).toString(), QStringLiteral("/scans/S_001.json"));
        card.tell({.robot = "R1"});
        QVERIFY(button(card, "Compare")->isHidden());
    }

private:
    QString write(const QString& name, const QByteArray& text) const {
        QFile file(folder_->filePath(name));
        if (file.open(QIODevice::WriteOnly))
            file.write(text);
        return file.fileName();
    }
    static QPushButton* button(const QWidget& widget, const QString& text) {
        const auto all = widget.findChildren<QPushButton*>();
        return *std::ranges::find(all, text, &QPushButton::text);
    }
    static bool says(const QWidget& widget, const QString& words) {
        return std::ranges::any_of(widget.findChildren<QLabel*>(), [&](const QLabel* label) {
            return label->isVisible() && label->text().contains(words);
        });
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

USAR_TEST(tst_RunComparison)

} // namespace tst_run_comparison

#include "tst_run_comparison.moc"
