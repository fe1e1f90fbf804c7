#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QDockWidget>
#include <QLabel>
#include <QListView>
#include <QMainWindow>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

#include "tests/suite/suite.h"
#include "widgets/commands/command_palette.h"
#include "widgets/commands/command_registry.h"
#include "widgets/commands/help.h"
#include "widgets/commands/key_filters.h"
#include "widgets/commands/shortcut_sheet.h"
#include "widgets/style/empty_state.h"

namespace tst_command_registry {

using namespace usar::widgets;

class tst_CommandRegistry : public QObject {
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void shortcutRunsTheCommand();
    void tooltipSaysWhatAndShortcut();
    void enabledRulesAreAskedOnRefresh();
    void anAdoptedActionIsListedAndKeepsItsWork();
    void menusAndBarsAreMadeFromIds();
    void scoresMatches_data();
    void scoresMatches();
    void aSynonymMatchesFromItsStart();
    void paletteModelIsSound();
    void paletteFindsAndRuns();
    void paletteListsWhatIsImpossibleLast();
    void paletteSaysThatNothingMatches();
    void paletteOffersWhatComesAndGoes();
    void paletteSpeaksWithVerbs();
    void allLabelsBeginAtOnePlace();
    void paletteIsLedByArrowKeys();
    void sheetListsEveryShortcut();
    void sheetPutsNumberedCommandsOnOneLine();
    void sheetFitsTheScreen();
    void sheetIsAsWideAsItsWords();
    void aboutTellsVersionsAndLicenses();
    void everyPartIsExplainedByItsTooltip();
    void escapeTwiceCounts_data();
    void escapeTwiceCounts();

private:
    std::unique_ptr<QMainWindow> window_;
    std::unique_ptr<CommandRegistry> registry_;
    QStringList ran_;
    bool flying_ = false;
};

void tst_CommandRegistry::init() {
    ran_.clear();
    flying_ = false;
    window_ = std::make_unique<QMainWindow>();
    window_->resize(800, 600);
    registry_ = std::make_unique<CommandRegistry>(window_.get());
    const auto add = [this](const QString& id, const QString& text, const QString& group, const QString& keys,
                            std::function<bool()> rule = {}) {
        const QList<QKeySequence> shortcuts =
            keys.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{QKeySequence(keys)};
        registry_->add(
            {id, text, group, text + QStringLiteral(" at once."), QStringLiteral("fit"), shortcuts},
            [this, id](bool) { ran_ << id; }, std::move(rule));
    };
    add(QStringLiteral("map.fit"), QStringLiteral("Fit mission in view"), QStringLiteral("Map"), QStringLiteral("F"));
    add(QStringLiteral("map.follow"), QStringLiteral("Follow robot"), QStringLiteral("Map"), QStringLiteral("Ctrl+F"));
    add(QStringLiteral("robot.land"), QStringLiteral("Land now"), QStringLiteral("Robot"), QStringLiteral("L"),
        [this] { return flying_; });
    add(QStringLiteral("file.export"), QStringLiteral("Export results"), QStringLiteral("Mission"), {});
    window_->show();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
}

void tst_CommandRegistry::cleanup() {
    registry_.reset();
    window_.reset();
}

void tst_CommandRegistry::shortcutRunsTheCommand() {
    QTest::keyClick(window_.get(), Qt::Key_F);
    QTest::keyClick(window_.get(), Qt::Key_F, Qt::ControlModifier);
    QCOMPARE(ran_, QStringList({QStringLiteral("map.fit"), QStringLiteral("map.follow")}));
}

void tst_CommandRegistry::tooltipSaysWhatAndShortcut() {
    QCOMPARE(registry_->action(QStringLiteral("map.fit"))->toolTip(),
             QStringLiteral("Fit mission in view at once. (F)"));
    QCOMPARE(registry_->action(QStringLiteral("file.export"))->toolTip(), QStringLiteral("Export results at once."));
    for (const auto& command : registry_->commands())
        QVERIFY(!command->action->icon().isNull());
}

void tst_CommandRegistry::enabledRulesAreAskedOnRefresh() {
    QAction* land = registry_->action(QStringLiteral("robot.land"));
    QVERIFY(!land->isEnabled());
    QTest::keyClick(window_.get(), Qt::Key_L);
    flying_ = true;
    registry_->refresh();
    QVERIFY(land->isEnabled());
    QTest::keyClick(window_.get(), Qt::Key_L);
    QCOMPARE(ran_, QStringList{QStringLiteral("robot.land")});
}

void tst_CommandRegistry::anAdoptedActionIsListedAndKeepsItsWork() {
    QAction other(QStringLiteral("Layers"));
    other.setCheckable(true);
    registry_->adopt({QStringLiteral("view.layers"),
                      QStringLiteral("Layers"),
                      QStringLiteral("View"),
                      QStringLiteral("Shows or hides them."),
                      {},
                      {QKeySequence(QStringLiteral("Ctrl+Y"))}},
                     &other);
    QVERIFY(registry_->action(QStringLiteral("view.layers")) == &other);
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    QTest::keyClick(window_.get(), Qt::Key_Y, Qt::ControlModifier);
    QVERIFY(other.isChecked());
}

void tst_CommandRegistry::menusAndBarsAreMadeFromIds() {
    QMenu menu;
    const QStringList ids{QStringLiteral("map.fit"), QStringLiteral("-"), QStringLiteral("file.export")};
    registry_->fill(&menu, ids);
    QCOMPARE(menu.actions().size(), 3);
    QCOMPARE(menu.actions()[0], registry_->action(ids[0]));
    QVERIFY(menu.actions()[1]->isSeparator());
    QVERIFY(menu.toolTipsVisible());
    QVERIFY(!registry_->contains(QStringLiteral("map.fly")));
}

void tst_CommandRegistry::scoresMatches_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<int>("score"); // -1: no match
    QTest::newRow("nothing typed") << QString() << 0;
    QTest::newRow("start of the text") << QStringLiteral("fit") << 3;
    QTest::newRow("start of a word, any case") << QStringLiteral("VIEW") << 2;
    QTest::newRow("within a word") << QStringLiteral("iss") << 1;
    QTest::newRow("two words in any order") << QStringLiteral("map fit") << 5;
    QTest::newRow("one of them missing") << QStringLiteral("fit land") << -1;
}

void tst_CommandRegistry::scoresMatches() {
    QFETCH(QString, typed);
    QFETCH(int, score);
    QCOMPARE(matchScore(typed, QStringLiteral("Fit mission in view Map")).value_or(-1), score);
}

void tst_CommandRegistry::aSynonymMatchesFromItsStart() {
    const QStringList words{"zoom", "fast forward"};
    QCOMPARE(matchScore("zo", "Fit mission", words).value_or(-1), 1);
    QCOMPARE(matchScore("oom", "Fit mission", words).value_or(-1), -1);
    QCOMPARE(matchScore("mission zoom", "Fit mission", words).value_or(-1), 3);
    QCOMPARE(matchScore("fast forward", "Fit mission", words).value_or(-1), 2);
}

void tst_CommandRegistry::paletteModelIsSound() {
    CommandListModel model(*registry_);
    QAbstractItemModelTester tester(&model);
    model.setFilter(QStringLiteral("map"));
    QCOMPARE(model.rowCount(), 2);
    model.setFilter(QStringLiteral("no such command"));
    QCOMPARE(model.rowCount(), 0);
    model.run({});
    QVERIFY(ran_.isEmpty());
}

void tst_CommandRegistry::paletteFindsAndRuns() {
    CommandPalette palette(*registry_, window_.get());
    palette.open();
    auto* line = palette.findChild<QLineEdit*>();
    QTest::keyClicks(line, QStringLiteral("expo"));
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(ran_, QStringList{QStringLiteral("file.export")});
    QVERIFY(palette.isHidden());
}

void tst_CommandRegistry::paletteListsWhatIsImpossibleLast() {
    CommandPalette palette(*registry_, window_.get());
    palette.open();
    auto* line = palette.findChild<QLineEdit*>();
    const auto* const list = palette.findChild<QListView*>();
    QCOMPARE(list->model()->rowCount(), 3);
    QTest::keyClicks(line, "o");
    QCOMPARE(list->model()->rowCount(), 4);
    const QModelIndex last = list->model()->index(3, 0);
    QCOMPARE(last.data().toString(), QString("Land now"));
    QVERIFY(!(last.flags() & Qt::ItemIsEnabled));
    line->clear();
    QTest::keyClicks(line, "land");
    QTest::keyClick(line, Qt::Key_Return);
    QVERIFY(ran_.isEmpty());
    QVERIFY(palette.isVisible());
}

void tst_CommandRegistry::paletteSaysThatNothingMatches() {
    CommandPalette palette(*registry_, window_.get());
    palette.open();
    const auto* const nothing = palette.findChild<EmptyState*>();
    QVERIFY(nothing && !nothing->isVisible());
    auto* line = palette.findChild<QLineEdit*>();
    QTest::keyClicks(line, "xyz");
    QVERIFY(nothing->isVisible());
    QCOMPARE(nothing->accessibleName(), QString("No command matches"));
    line->clear();
    QVERIFY(!nothing->isVisible());
}

void tst_CommandRegistry::paletteOffersWhatComesAndGoes() {
    QStringList robots{"R1"};
    registry_->offer([&] {
        std::vector<PaletteOffer> offers;
        for (const QString& name : robots)
            offers.push_back({"Select " + name, "Robots", {"choose"}, [this, name] { ran_ << name; }});
        return offers;
    });
    CommandPalette palette(*registry_, window_.get());
    robots = {"R1", "R2"};
    palette.open();
    auto* line = palette.findChild<QLineEdit*>();
    const auto* const list = palette.findChild<QListView*>();
    QCOMPARE(list->model()->rowCount(), 3); // Commands only, until something is typed.
    QTest::keyClicks(line, "choose");
    QCOMPARE(list->model()->rowCount(), 2);
    QTest::keyClick(line, Qt::Key_Down);
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(ran_, QStringList{"R2"});
    QVERIFY(palette.isHidden());
}

void tst_CommandRegistry::paletteSpeaksWithVerbs() {
    std::vector<bool> shown;
    registry_->add(
        {.id = "view.dock.camera", .text = "Camera", .group = "View", .checkable = true, .wish = "Show Camera"},
        [&shown](bool on) { shown.push_back(on); });
    QCOMPARE(registry_->action("view.dock.camera")->text(), QString("Camera"));
    CommandListModel model(*registry_);
    model.setFilter("camera");
    QCOMPARE(model.index(0).data().toString(), QString("Show Camera"));
    for (int i = 0; i < 2; ++i) // The second time it is shown already, and it stays so.
        model.run(model.index(0));
    QCOMPARE(shown, (std::vector<bool>{true, true}));
}

void tst_CommandRegistry::allLabelsBeginAtOnePlace() {
    registry_->add({.id = "view.plain", .text = "Plain", .group = "View"}, [](bool) {});
    registry_->offer([] { return std::vector<PaletteOffer>{{"Plain offer", "View", {}, [] {}}}; });
    CommandListModel model(*registry_);
    model.setFilter("plain");
    QCOMPARE(model.rowCount(), 2);
    for (int row = 0; row < 2; ++row)
        QCOMPARE(model.index(row).data(Qt::DecorationRole).value<QIcon>().actualSize({16, 16}), QSize(16, 16));
}

void tst_CommandRegistry::paletteIsLedByArrowKeys() {
    CommandPalette palette(*registry_, window_.get());
    palette.open();
    auto* line = palette.findChild<QLineEdit*>();
    QTest::keyClick(line, Qt::Key_Up);
    QTest::keyClick(line, Qt::Key_Down);
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(ran_, QStringList{QStringLiteral("map.follow")});
}

void tst_CommandRegistry::sheetListsEveryShortcut() {
    const QDialog* const sheet = makeShortcutSheet(*registry_, window_.get());
    QStringList texts;
    for (const QLabel* label : sheet->findChildren<QLabel*>())
        texts << label->text();
    for (const auto& command : registry_->commands())
        QCOMPARE(texts.contains(command->spec.text), !command->spec.shortcuts.isEmpty());
    QVERIFY(texts.contains(QStringLiteral("Wheel")) && texts.contains(QStringLiteral("Ctrl+F")));
}

void tst_CommandRegistry::sheetPutsNumberedCommandsOnOneLine() {
    for (int number = 1; number <= 9; ++number)
        registry_->add({.id = QString("robot.select_%1").arg(number),
                        .text = QString("Select robot %1").arg(number),
                        .group = "Robot",
                        .shortcuts = {QKeySequence(QString::number(number))}},
                       [](bool) {});
    registry_->add({.id = "mission.stop_all",
                    .text = "Stop all robots",
                    .group = "Robot",
                    .shortcuts = {QKeySequence("Ctrl+.")},
                    .twice = QKeySequence("Esc")},
                   [](bool) {});
    const QDialog* const sheet = makeShortcutSheet(*registry_, window_.get());
    QStringList texts;
    for (const QLabel* label : sheet->findChildren<QLabel*>())
        texts << label->text();
    QCOMPARE(texts.filter("Select robot"), QStringList("Select robot 1 – 9"));
    QVERIFY(texts.contains("1 – 9"));
    QVERIFY(texts.contains("Ctrl+.  Esc Esc"));
    QVERIFY(texts.contains("N  Shift+N"));
}

/// All commands of the program; on this screen of 800 x 800 they are in two columns.
void tst_CommandRegistry::sheetFitsTheScreen() {
    const auto window = std::make_unique<QMainWindow>();
    CommandRegistry registry(window.get());
    for (const CommandSpec& spec : commandTable())
        registry.add(spec, [](bool) {});
    QDialog* const sheet = makeShortcutSheet(registry, window.get());
    sheet->show();
    QVERIFY(QTest::qWaitForWindowExposed(sheet));
    const QSize screen = sheet->screen()->availableSize();
    QVERIFY2(sheet->width() <= screen.width() && sheet->height() <= screen.height(),
             qPrintable(QString("%1 x %2").arg(sheet->width()).arg(sheet->height())));
    const auto* const bar = sheet->findChild<QScrollArea*>()->verticalScrollBar();
    QVERIFY2(bar->maximum() <= 2 * bar->pageStep(), qPrintable(QString::number(bar->maximum())));
}

void tst_CommandRegistry::sheetIsAsWideAsItsWords() {
    registry_->add({"map.long", QString(120, u'w'), "Map", {}, {}, {QKeySequence("Ctrl+L")}}, [](bool) {});
    QDialog* const sheet = makeShortcutSheet(*registry_, window_.get());
    sheet->show();
    QVERIFY(QTest::qWaitForWindowExposed(sheet));
    QCOMPARE(sheet->findChild<QScrollArea*>()->horizontalScrollBar()->maximum(), 0);
}

void tst_CommandRegistry::aboutTellsVersionsAndLicenses() {
    const QDialog* const about = makeAbout(window_.get());
    QVERIFY(!about->isModal());
    QStringList texts;
    for (const QLabel* label : about->findChildren<QLabel*>())
        texts << label->text();
    const QString all = texts.join(' ');
    QVERIFY(all.contains(QCoreApplication::applicationName()));
    QVERIFY(all.contains("General Public License"));
    const auto* const table = about->findChild<QTreeWidget*>();
    QVERIFY(table && !table->findItems("Qt", Qt::MatchExactly).isEmpty());
    QCOMPARE(table->findItems("Qt", Qt::MatchExactly).front()->text(1), QString::fromLatin1(qVersion()));
    for (int row = 0; row < table->topLevelItemCount(); ++row)
        for (int column = 0; column < table->columnCount(); ++column)
            QVERIFY2(!table->topLevelItem(row)->text(column).isEmpty(), qPrintable(table->topLevelItem(row)->text(0)));
    for (QPushButton* button : about->findChildren<QPushButton*>())
        if (button->text().contains("Copy"))
            button->click();
    QVERIFY(QGuiApplication::clipboard()->text().contains(QString("Qt %1 (LGPL-3.0-only)").arg(qVersion())));
}

void tst_CommandRegistry::everyPartIsExplainedByItsTooltip() {
    auto* const dock = new QDockWidget("Instruments", window_.get());
    auto* const speed = new QLabel("0.8");
    speed->setToolTip("Speed over the ground, m/s");
    dock->setWidget(speed);
    window_->addDockWidget(Qt::LeftDockWidgetArea, dock);
    auto* const own = new QLabel("own", window_.get());
    own->setToolTip("A tooltip");
    own->setWhatsThis("More words");
    explainParts(*window_);
    QCOMPARE(speed->whatsThis(), QString("Speed over the ground, m/s"));
    QCOMPARE(dock->whatsThis(), QString("Instruments: Speed over the ground, m/s"));
    QCOMPARE(own->whatsThis(), QString("More words"));
}

void tst_CommandRegistry::escapeTwiceCounts_data() {
    QTest::addColumn<QList<int>>("keys");
    QTest::addColumn<QList<int>>("at_ms");
    QTest::addColumn<int>("stops");
    const int esc = Qt::Key_Escape;
    QTest::newRow("once") << QList<int>{esc} << QList<int>{1000} << 0;
    QTest::newRow("twice") << QList<int>{esc, esc} << QList<int>{1000, 1300} << 1;
    QTest::newRow("too slow") << QList<int>{esc, esc} << QList<int>{1000, 1900} << 0;
    QTest::newRow("slow, then quick") << QList<int>{esc, esc, esc} << QList<int>{1000, 1900, 2100} << 1;
    QTest::newRow("another key between") << QList<int>{esc, Qt::Key_A, esc} << QList<int>{1000, 1100, 1200} << 0;
    QTest::newRow("four times are two stops") << QList<int>{esc, esc, esc, esc} << QList<int>{1, 2, 3, 4} << 2;
}

void tst_CommandRegistry::escapeTwiceCounts() {
    QFETCH(QList<int>, keys);
    QFETCH(QList<int>, at_ms);
    KeyTwice watch(QKeySequence("Esc"));
    QSignalSpy stops(&watch, &KeyTwice::pressedTwice);
    for (qsizetype i = 0; i < keys.size(); ++i) {
        QKeyEvent press(QEvent::KeyPress, keys[i], Qt::NoModifier);
        press.setTimestamp(static_cast<quint64>(at_ms[i]));
        QCoreApplication::sendEvent(window_->windowHandle(), &press);
    }
    QTEST(int(stops.count()), "stops");
}

USAR_TEST(tst_CommandRegistry)

} // namespace tst_command_registry

#include "tst_command_registry.moc"
