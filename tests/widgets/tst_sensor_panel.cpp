#include <QAbstractItemModelTester>
#include <QLabel>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/models/figures.h"
#include "widgets/panels/sensor_panel.h"
#include "widgets/style/theme.h"

namespace tst_sensor_panel {

using namespace usar;
using namespace usar::widgets;

namespace {

protocol::InfoLine line(protocol::InfoMessage message) {
    return {{1}, {}, std::move(message), {}};
}

protocol::InfoLine sonar(const char* name, double range_m) {
    return line(protocol::SonarReadings{Seconds(1.0), {{name, range_m}}});
}

protocol::InfoLine ins(double x_m, double yaw_rad) {
    return line(protocol::InsReading{{}, "INS", {{x_m, 0.0, 0.0}, 0.0, 0.0, yaw_rad}});
}

/// The leaf with this path in any model over the sensor model.
QModelIndex leaf(const QAbstractItemModel& model, const QString& path) {
    for (int s = 0; s < model.rowCount(); ++s)
        for (int l = 0; l < model.rowCount(model.index(s, 0)); ++l)
            if (const auto at = model.index(l, 0, model.index(s, 0)); at.data(SensorModel::PathRole).toString() == path)
                return at;
    return {};
}

QString textAt(const QModelIndex& row, SensorModel::Column column) {
    return row.siblingAtColumn(column).data().toString();
}

QString pathEndingIn(const QAbstractItemModel& model, const QString& end) {
    for (int s = 0; s < model.rowCount(); ++s)
        for (int l = 0; l < model.rowCount(model.index(s, 0)); ++l)
            if (const QString path = model.index(l, 0, model.index(s, 0)).data(SensorModel::PathRole).toString();
                path.endsWith(end))
                return path;
    return {};
}

/// True if the value at `index` is painted as out of date.
bool isStale(const QModelIndex& index) {
    return index.data(Qt::ForegroundRole).value<QColor>() == tokens().stale;
}

/// A panel whose wall clock the test moves, after one scan at 1 s of the protocol's clock.
struct TimedPanel {
    TimedPanel() {
        panel.setWallClock([this] { return wall; });
        panel.take(sonar("F1", 2.0), Seconds(1.0));
        panel.show();
    }
    QModelIndex range() const { return leaf(panel.model(), pathEndingIn(panel.model(), QStringLiteral("F1/range"))); }
    bool stale() {
        panel.refresh();
        return isStale(range());
    }

    Seconds wall{100.0};
    SensorPanel panel;
};

} // namespace

class tst_SensorPanel : public QObject {
    Q_OBJECT
private slots:
    void modelIsSound();
    void oneBranchASourceOneLeafAValue();
    void anglesAreShownInDegrees();
    void decimalsNeverShrink();
    void staleAfterThreePeriodsAndASecond_data();
    void staleAfterThreePeriodsAndASecond();
    void staleIsStruckOut();
    void answersAreNeverStale();
    void noLinkIsStaleAtOnce();
    void rateFollowsTheMessages();
    void countedLinesGiveTheSameRate();
    void dragsNumbersOnly();
    void unknownSensorsAppear();
    void streamsAreKeptApart();
    void newestLineOfAStreamRemains();
    void newestReadingOfATypeHasItsTime();
    void streamsAreListedBeforeAnswers();
    void everyValueHasItsRate();
    void silenceIsStaleAndAgesByWallTime();
    void pausedSimulationIsNotSilent();
    void slowSimulationIsNotSilent();
    void lostLinkAgesByWallTime();
    void doubleClickPlots();
    void returnPlots();
    void filterKeepsBranchesOfMatches();
    void hiddenPanelDoesNoWorkAndLosesNothing();
    void clearForgets();
    void emptyPanelIsNeverCut_data();
    void emptyPanelIsNeverCut();
};

void tst_SensorPanel::modelIsSound() {
    SensorModel model;
    QAbstractItemModelTester tester(&model);
    model.take(sonar("F1", 2.0), Seconds(1.0));
    model.take(ins(1.0, 0.5), Seconds(1.0));
    model.take(sonar("F2", 3.0), Seconds(1.1));
    model.flush(Seconds(1.2));
    QCOMPARE(model.rowCount(), 2);
    model.clear();
    QCOMPARE(model.rowCount(), 0);
}

void tst_SensorPanel::oneBranchASourceOneLeafAValue() {
    SensorModel model;
    model.take(sonar("F1", 2.0), Seconds(1.0));
    model.take(sonar("F2", 3.5), Seconds(1.0));
    QCOMPARE(model.index(0, 0).data().toString(), QStringLiteral("Sonar"));
    const QString path = pathEndingIn(model, QStringLiteral("F2/range"));
    const QModelIndex row = leaf(model, path);
    QVERIFY2(row.isValid(), qPrintable(path));
    QCOMPARE(textAt(row, SensorModel::Name), QStringLiteral("F2  range"));
    QCOMPARE(textAt(row, SensorModel::Value), QStringLiteral("3.50"));
    QCOMPARE(textAt(row, SensorModel::Unit), QStringLiteral("m"));
}

void tst_SensorPanel::anglesAreShownInDegrees() {
    SensorModel model;
    model.take(ins(1.0, radians(-30.0)), Seconds(1.0));
    const QModelIndex yaw = leaf(model, pathEndingIn(model, QStringLiteral("/yaw")));
    QCOMPARE(textAt(yaw, SensorModel::Value), QStringLiteral("−30.0"));
    QCOMPARE(textAt(yaw, SensorModel::Unit), QStringLiteral("°"));
    QCOMPARE(yaw.data(SensorModel::UnitRole).toString(), QStringLiteral("rad"));
}

void tst_SensorPanel::decimalsNeverShrink() {
    SensorModel model;
    const auto generic = [](const char* value) {
        return line(
            protocol::GenericMessage{"SEN", "Thermo", "T1", {{"Type", "Thermo"}, {"Name", "T1"}, {"Heat", value}}});
    };
    model.take(generic("3.25"), Seconds(1.0));
    const QString path = pathEndingIn(model, QStringLiteral("Heat"));
    QCOMPARE(textAt(leaf(model, path), SensorModel::Value), QStringLiteral("3.250"));
    model.take(generic("4"), Seconds(1.2));
    QCOMPARE(textAt(leaf(model, path), SensorModel::Value), QStringLiteral("4.000"));
}

void tst_SensorPanel::staleAfterThreePeriodsAndASecond_data() {
    QTest::addColumn<double>("period_s");
    QTest::addColumn<double>("age_s");
    QTest::addColumn<bool>("stale");
    QTest::newRow("fresh") << 0.2 << 0.1 << false;
    QTest::newRow("three periods, but not a second") << 0.2 << 0.9 << false;
    QTest::newRow("more than a second") << 0.2 << 1.1 << true;
    QTest::newRow("a slow stream has time") << 2.0 << 5.5 << false;
    QTest::newRow("a slow stream that stopped") << 2.0 << 6.5 << true;
}

void tst_SensorPanel::staleAfterThreePeriodsAndASecond() {
    QFETCH(double, period_s);
    QFETCH(double, age_s);
    SensorModel model;
    Seconds now(10.0);
    for (int i = 0; i < 20; ++i)
        model.take(sonar("F1", 2.0), now += Seconds(period_s));
    model.flush(now + Seconds(age_s));
    QTEST(isStale(leaf(model, pathEndingIn(model, QStringLiteral("F1/range")))), "stale");
}

void tst_SensorPanel::staleIsStruckOut() {
    SensorModel model;
    model.take(sonar("F1", 2.0), Seconds(1.0));
    const QModelIndex value =
        leaf(model, pathEndingIn(model, QStringLiteral("F1/range"))).siblingAtColumn(SensorModel::Value);
    model.flush(Seconds(1.1));
    QVERIFY(!value.data(Qt::FontRole).value<QFont>().strikeOut());
    QCOMPARE(value.data(Qt::ForegroundRole).value<QColor>(), tokens().text);
    model.flush(Seconds(9.0));
    QVERIFY(value.data(Qt::FontRole).value<QFont>().strikeOut());
    QCOMPARE(value.data(Qt::ForegroundRole).value<QColor>(), tokens().stale);
}

void tst_SensorPanel::answersAreNeverStale() {
    SensorModel model;
    model.take(line(protocol::GameInfo{"USARBot.USARDeathMatch", "DM-Mapping_250", {}}), Seconds(1.0));
    model.flush(Seconds(1000.0), false);
    QVERIFY(!isStale(model.index(0, 0)));
    QCOMPARE(textAt(model.index(0, 0), SensorModel::Age), QStringLiteral("answer"));
}

void tst_SensorPanel::noLinkIsStaleAtOnce() {
    SensorModel model;
    model.take(sonar("F1", 2.0), Seconds(1.0));
    model.flush(Seconds(1.0), false);
    QVERIFY(isStale(model.index(0, 0)));
    model.flush(Seconds(1.0), true);
    QVERIFY(!isStale(model.index(0, 0)));
}

void tst_SensorPanel::rateFollowsTheMessages() {
    SensorModel model;
    for (int i = 1; i <= 40; ++i)
        model.take(ins(i, 0.0), Seconds(0.2 * i));
    QCOMPARE(textAt(model.index(0, 0), SensorModel::Rate), QStringLiteral("5.0 Hz"));
    for (int i = 1; i <= 40; ++i)
        model.take(ins(i, 0.0), Seconds(8.0 + 0.1 * i));
    QCOMPARE(textAt(model.index(0, 0), SensorModel::Rate), QStringLiteral("10.0 Hz"));
}

void tst_SensorPanel::countedLinesGiveTheSameRate() {
    SensorModel model;
    for (int i = 1; i <= 20; ++i)
        model.take(ins(i, 0.0), Seconds(1.0 * i), 5);
    QCOMPARE(textAt(model.index(0, 0), SensorModel::Rate), QStringLiteral("5.0 Hz"));
}

void tst_SensorPanel::dragsNumbersOnly() {
    SensorModel model;
    model.take(sonar("F1", 2.0), Seconds(1.0));
    const QString path = pathEndingIn(model, QStringLiteral("F1/range"));
    const QModelIndex row = leaf(model, path);
    const std::unique_ptr<QMimeData> mime(model.mimeData({row, row.siblingAtColumn(SensorModel::Value)}));
    QVERIFY(mime);
    QCOMPARE(mime->data(model.mimeTypes().front()), path.toUtf8());
    QVERIFY(model.flags(row) & Qt::ItemIsDragEnabled);
    QVERIFY(!(model.flags(model.index(0, 0)) & Qt::ItemIsDragEnabled));
    QCOMPARE(model.mimeData({model.index(0, 0)}), nullptr);
}

void tst_SensorPanel::unknownSensorsAppear() {
    SensorModel model;
    model.take(
        line(protocol::GenericMessage{"SEN", "Victim", "V1", {{"Type", "Victim"}, {"Name", "V1"}, {"Part", "head"}}}),
        Seconds(1.0));
    const QModelIndex part = leaf(model, pathEndingIn(model, QStringLiteral("Part")));
    QCOMPARE(textAt(part, SensorModel::Value), QStringLiteral("head"));
    QVERIFY(!part.data(SensorModel::NumericRole).toBool());
}

void tst_SensorPanel::streamsAreKeptApart() {
    QCOMPARE(streamOf(sonar("F1", 1.0).message), streamOf(sonar("F1", 2.0).message));
    QVERIFY(streamOf(sonar("F1", 1.0).message) != streamOf(sonar("F2", 1.0).message));
    QVERIFY(streamOf(protocol::RobotState{}) != streamOf(protocol::InsReading{}));
    QVERIFY(streamOf(protocol::GeometryInfo{.type = "Sonar"}) != streamOf(protocol::GeometryInfo{.type = "INS"}));
}

void tst_SensorPanel::newestLineOfAStreamRemains() {
    NewestLines newest;
    newest.take(sonar("F1", 1.0), Seconds(1.0));
    newest.take(ins(0.0, 0.0), Seconds(1.0));
    newest.take(sonar("F1", 2.0), Seconds(1.2));
    const auto lines = newest.takeAll();
    QCOMPARE(lines.size(), std::size_t(2));
    QCOMPARE(lines[0].count, 2);
    QCOMPARE(lines[0].now, Seconds(1.2));
    QCOMPARE(std::get<protocol::SonarReadings>(lines[0].line.message).ranges[0].range_m, 2.0);
    QVERIFY(newest.takeAll().empty());
}

void tst_SensorPanel::newestReadingOfATypeHasItsTime() {
    NewestLines newest;
    newest.take(sonar("F1", 1.0), Seconds(1.0));
    newest.take(sonar("F2", 1.0), Seconds(1.5));
    newest.take(sonar("F1", 2.0), Seconds(1.2));
    QCOMPARE(newest.heard<protocol::SonarReadings>(), std::optional(Seconds(1.5)));
    QVERIFY(!newest.heard<protocol::InsReading>());
    newest.takeAll();
    QVERIFY(!newest.heard<protocol::SonarReadings>());
}

void tst_SensorPanel::streamsAreListedBeforeAnswers() {
    SensorPanel panel;
    panel.take(line(protocol::GameInfo{"game", "level", {}}), Seconds(0.0));
    panel.take(line(protocol::GenericMessage{"GEO", "Arm", "A", {{"Part", "hand"}}}), Seconds(0.0));
    panel.take(sonar("F1", 2.0), Seconds(1.0));
    panel.take(ins(1.0, 0.0), Seconds(1.0));
    panel.show();
    const QAbstractItemModel* shown = panel.findChild<QTreeView*>()->model();
    QStringList names;
    for (int row = 0; row < shown->rowCount(); ++row)
        names << shown->index(row, 0).data().toString().section(u' ', 0, 0);
    QCOMPARE(names.size(), 4);
    QCOMPARE(names[0], QStringLiteral("Sonar"));
    QCOMPARE(names[1], QStringLiteral("INS"));
    QVERIFY(names[2].startsWith(QStringLiteral("NFO")));
    QVERIFY(names[3].startsWith(QStringLiteral("GEO")));
}

void tst_SensorPanel::everyValueHasItsRate() {
    SensorModel model;
    for (int i = 1; i <= 20; ++i)
        model.take(ins(i, 0.0), Seconds(0.2 * i));
    const QModelIndex value = model.index(0, 0, model.index(0, 0));
    QCOMPARE(textAt(value, SensorModel::Rate), QStringLiteral("5.0 Hz"));
    QCOMPARE(value.siblingAtColumn(SensorModel::Rate).data(Qt::ForegroundRole).value<QColor>(), tokens().text_muted);
}

void tst_SensorPanel::silenceIsStaleAndAgesByWallTime() {
    TimedPanel timed;
    timed.wall += Seconds(1.9);
    QVERIFY(!timed.stale());
    timed.wall += Seconds(0.2);
    QVERIFY(timed.stale());
    timed.wall += Seconds(7.9);
    QVERIFY(timed.stale());
    QCOMPARE(textAt(timed.range(), SensorModel::Age), ageText(Seconds(10.0)));
    timed.panel.take(sonar("F1", 2.0), Seconds(1.2));
    QVERIFY(!timed.stale());
}

void tst_SensorPanel::pausedSimulationIsNotSilent() {
    TimedPanel timed;
    timed.panel.setPaused(true);
    timed.wall += Seconds(60.0);
    QVERIFY(!timed.stale());
    timed.panel.setPaused(false);
    QVERIFY(!timed.stale());
    timed.wall += Seconds(3.0);
    QVERIFY(timed.stale());
}

// At a tenth of real time a server of 5 Hz speaks every two seconds.
void tst_SensorPanel::slowSimulationIsNotSilent() {
    TimedPanel timed;
    for (int i = 1; i <= 5; ++i) {
        timed.wall += Seconds(2.0);
        timed.panel.take(sonar("F1", 2.0), Seconds(1.0 + 0.2 * i));
    }
    timed.wall += Seconds(2.2);
    QVERIFY(!timed.stale());
}

void tst_SensorPanel::lostLinkAgesByWallTime() {
    TimedPanel timed;
    timed.panel.setLinked(false);
    QVERIFY(timed.stale());
    timed.wall += Seconds(5.0);
    timed.panel.refresh();
    QCOMPARE(textAt(timed.range(), SensorModel::Age), ageText(Seconds(5.0)));
    timed.panel.setLinked(true);
    timed.panel.take(sonar("F1", 2.0), Seconds(1.2));
    QVERIFY(!timed.stale());
}

void tst_SensorPanel::doubleClickPlots() {
    SensorPanel panel;
    panel.resize(340, 300);
    panel.take(sonar("F1", 2.0), Seconds(1.0));
    panel.show();
    QSignalSpy plots(&panel, &SensorPanel::plotRequested);
    auto* tree = panel.findChild<QTreeView*>();
    const QString path = pathEndingIn(panel.model(), QStringLiteral("F1/range"));
    const QRect row = tree->visualRect(leaf(*tree->model(), path));
    QVERIFY2(row.isValid(), "new branches are open");
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, row.center());
    QTest::mouseDClick(tree->viewport(), Qt::LeftButton, {}, row.center());
    QCOMPARE(plots.count(), 1);
    QCOMPARE(plots[0][0].toString(), path);
    QCOMPARE(plots[0][1].toString(), QStringLiteral("m"));
}

void tst_SensorPanel::returnPlots() {
    SensorPanel panel;
    panel.take(sonar("F1", 2.0), Seconds(1.0));
    panel.show();
    QSignalSpy plots(&panel, &SensorPanel::plotRequested);
    auto* tree = panel.findChild<QTreeView*>();
    tree->setCurrentIndex(tree->model()->index(0, 0));
    QTest::keyClick(tree, Qt::Key_Return);
    QCOMPARE(plots.count(), 0);
    tree->setCurrentIndex(leaf(*tree->model(), pathEndingIn(panel.model(), QStringLiteral("F1/range"))));
    QTest::keyClick(tree, Qt::Key_Return);
    QCOMPARE(plots.count(), 1);
}

void tst_SensorPanel::filterKeepsBranchesOfMatches() {
    SensorPanel panel;
    panel.take(sonar("F1", 2.0), Seconds(1.0));
    panel.take(ins(1.0, 0.0), Seconds(1.0));
    panel.show();
    const QAbstractItemModel* shown = panel.findChild<QTreeView*>()->model();
    QCOMPARE(shown->rowCount(), 2);
    QTest::keyClicks(panel.findChild<QLineEdit*>(), QStringLiteral("f1"));
    QCOMPARE(shown->rowCount(), 1);
    QCOMPARE(shown->rowCount(shown->index(0, 0)), 1);
    panel.findChild<QLineEdit*>()->setText(QStringLiteral("ins"));
    QVERIFY(shown->rowCount(shown->index(0, 0)) >= 6);
}

void tst_SensorPanel::hiddenPanelDoesNoWorkAndLosesNothing() {
    SensorPanel panel;
    panel.show();
    panel.hide();
    QSignalSpy changed(&panel.model(), &QAbstractItemModel::rowsInserted);
    for (int i = 0; i < 100; ++i)
        panel.take(sonar("F1", 0.01 * i), Seconds(0.2 * i));
    panel.take(line(protocol::GameInfo{"game", "level", {}}), Seconds(20.0));
    QCOMPARE(changed.count(), 0);
    panel.show();
    QCOMPARE(panel.model().rowCount(), 2);
    QCOMPARE(textAt(leaf(panel.model(), pathEndingIn(panel.model(), QStringLiteral("F1/range"))), SensorModel::Value),
             QStringLiteral("0.99"));
}

void tst_SensorPanel::clearForgets() {
    SensorPanel panel;
    panel.show();
    auto* sheet = panel.findChild<QWidget*>(QStringLiteral("emptyState"));
    QVERIFY(sheet->isVisible());
    panel.take(sonar("F1", 2.0), Seconds(1.0));
    panel.refresh();
    QVERIFY(sheet->isHidden());
    panel.clear();
    QCOMPARE(panel.model().rowCount(), 0);
    QVERIFY(sheet->isVisible());
}

void tst_SensorPanel::emptyPanelIsNeverCut_data() {
    QTest::addColumn<int>("height");
    QTest::newRow("1280x800") << 160;
    QTest::newRow("low") << 60;
}

void tst_SensorPanel::emptyPanelIsNeverCut() {
    QFETCH(int, height);
    QWidget window; // A panel that is a window itself would not be that low.
    SensorPanel panel(&window);
    panel.setGeometry(0, 0, 300, height);
    window.show();
    QCOMPARE(panel.height(), height);
    auto* sheet = panel.findChild<QWidget*>(QStringLiteral("emptyState"));
    const auto labels = sheet->findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly);
    for (const QLabel* label : labels)
        QTRY_VERIFY(!label->isVisible() || (label->height() >= label->heightForWidth(label->width()) &&
                                            sheet->rect().contains(label->geometry())));
}

USAR_TEST(tst_SensorPanel)

} // namespace tst_sensor_panel

#include "tst_sensor_panel.moc"
