// Layouts of one's own and changed keys: they come back from their files, and each change is told so that it can be
// undone.
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QMainWindow>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/commands/key_file.h"
#include "widgets/map/layers_panel.h"
#include "widgets/window/layout_keeper.h"

namespace tst_layout_keeper {

using namespace usar::widgets;

namespace {

/// A window with one dock, whose content is a number, and its keeper.
struct Bench {
    QMainWindow window;
    QDockWidget* dock = new QDockWidget("Plots", &window);
    CommandRegistry registry{&window};
    int content = 1;
    LayoutKeeper keeper;
    QStringList troubles;

    explicit Bench(const QString& folder) : keeper(window, registry, folder) {
        dock->setObjectName("plots");
        dock->setWidget(new QLabel("curves"));
        window.setCentralWidget(new QLabel("map"));
        window.addDockWidget(Qt::LeftDockWidgetArea, dock);
        window.resize(800, 600);
        window.show();
        QObject::connect(&keeper, &LayoutKeeper::failed, &keeper,
                         [this](const usar::Error& error) { troubles << QString::fromStdString(error.text()); });
        keeper.addView(
            "plots",
            [this] {
                return QJsonObject{{"content", content}};
            },
            [this](const QJsonObject& json) { content = json["content"].toInt(); });
        keeper.registerCommands();
        keeper.read();
    }
    LayoutDialog* openDialog() {
        registry.action("view.layouts")->trigger();
        return window.findChild<LayoutDialog*>();
    }
    /// What the palette offers.
    QStringList offers() const {
        QStringList texts;
        for (const PaletteOffer& offer : registry.offers())
            texts << offer.text;
        return texts;
    }
};

} // namespace

class tst_LayoutKeeper : public QObject {
    Q_OBJECT
private slots:
    void aSavedLayoutComesBackWithTheContentOfItsDocks() {
        const QTemporaryDir folder;
        {
            Bench bench(folder.path());
            emit bench.openDialog()->saveRequested("Mine");
        }
        Bench bench(folder.path());
        QTRY_COMPARE(bench.offers(), QStringList("Layout: Mine"));
        bench.dock->hide();
        bench.content = 2;
        bench.registry.offers().front().run();
        QVERIFY(!bench.dock->isHidden());
        QCOMPARE(bench.content, 1);
        QCOMPARE(bench.troubles, QStringList());
    }

    void aShownLayoutIsTakenBackWithTheContentOfItsDocks() {
        const QTemporaryDir folder;
        Bench bench(folder.path());
        emit bench.openDialog()->saveRequested("Mine");
        bench.dock->hide();
        bench.content = 2;
        DockState before;
        DockState after;
        connect(&bench.keeper, &LayoutKeeper::docksEdited, this,
                [&](const QString& text, const DockState& one, const DockState& other) {
                    QCOMPARE(text, QString("show layout Mine"));
                    before = one;
                    after = other;
                });
        bench.registry.offers().front().run();
        bench.keeper.setDocks(before);
        QVERIFY(bench.dock->isHidden());
        QCOMPARE(bench.content, 2);
        bench.keeper.setDocks(after);
        QVERIFY(!bench.dock->isHidden());
        QCOMPARE(bench.content, 1);
    }

    void anArrangementOfTheProgramLeavesTheContentAlone() {
        const QTemporaryDir folder;
        Bench bench(folder.path());
        DockState before;
        connect(&bench.keeper, &LayoutKeeper::docksEdited, this,
                [&](const QString&, const DockState& one, const DockState&) { before = one; });
        bench.keeper.rearrange("operate", [&] { bench.dock->hide(); });
        bench.content = 2; // Such an edit is no step of the history.
        bench.keeper.setDocks(before);
        QVERIFY(!bench.dock->isHidden());
        QCOMPARE(bench.content, 2);
    }

    void eachChangeOfTheListIsToldAndCanBeTakenBack() {
        const QTemporaryDir folder;
        Bench bench(folder.path());
        QStringList texts;
        Layouts before;
        connect(&bench.keeper, &LayoutKeeper::layoutsEdited, this,
                [&](const QString& text, const Layouts& one, const Layouts&) {
                    texts << text;
                    before = one;
                });
        LayoutDialog* const dialog = bench.openDialog();
        emit dialog->saveRequested("Mine");
        emit dialog->renameRequested("Mine", "Yours");
        QCOMPARE(bench.offers(), QStringList("Layout: Yours"));
        emit dialog->removeRequested("Yours");
        QCOMPARE(texts, (QStringList{"save layout Mine", "rename layout Mine", "delete layout Yours"}));
        QVERIFY(bench.offers().isEmpty());
        bench.keeper.setLayouts(before);
        QCOMPARE(texts.size(), 3);
        QTRY_COMPARE(QDir(folder.path()).entryList({"*.json"}), QStringList("Yours.json"));
        QCOMPARE(bench.troubles, QStringList());
    }

    void aDamagedFileIsNamed() {
        const QTemporaryDir folder;
        QFile file(folder.path() + "/Broken.json");
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("{") > 0);
        file.close();
        Bench bench(folder.path());
        QTRY_COMPARE(bench.troubles.size(), 1);
        QVERIFY2(bench.troubles.front().contains("Broken.json"), qPrintable(bench.troubles.front()));
    }

    void aChangedKeyComesBackFromItsFile() {
        const QTemporaryDir folder;
        const QString path = folder.path() + "/new/keys.json";
        for (const bool first : {true, false}) {
            QMainWindow window;
            CommandRegistry registry(&window);
            QAction* const fit = registry.add({"map.fit", "Fit", "Map", "Fits.", {}, {QKeySequence("F")}}, [](bool) {});
            KeyFile keys(registry, path);
            QSignalSpy failures(&keys, &KeyFile::failed);
            keys.read();
            QCOMPARE(fit->shortcut(), QKeySequence(first ? "F" : "Ctrl+9"));
            registry.setKeys("map.fit", {QKeySequence("Ctrl+9")});
            QTRY_VERIFY(QFile::exists(path));
            QCOMPARE(failures.count(), 0);
        }
    }

    void aDamagedFileOfKeysChangesNothing() {
        const QTemporaryDir folder;
        const QString path = folder.path() + "/keys.json";
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("[1]") > 0);
        file.close();
        QMainWindow window;
        CommandRegistry registry(&window);
        QAction* const fit = registry.add({"map.fit", "Fit", "Map", "Fits.", {}, {QKeySequence("F")}}, [](bool) {});
        KeyFile keys(registry, path);
        QSignalSpy failures(&keys, &KeyFile::failed);
        keys.read();
        QCOMPARE(failures.count(), 1);
        QCOMPARE(fit->shortcut(), QKeySequence("F"));
    }

    void anEditOfALayerIsToldAndARestoredStateIsNone() {
        LayersPanel layers;
        QSignalSpy edits(&layers, &LayersPanel::edited);
        const QByteArray first = layers.saveState();
        QToolButton* grid = nullptr;
        for (QToolButton* const eye : layers.findChildren<QToolButton*>())
            if (eye->accessibleName() == "Show " + layerName(MapLayer::Grid))
                grid = eye;
        QVERIFY(grid);
        grid->click();
        QCOMPARE(edits.count(), 1);
        QCOMPARE(edits[0][0].toString(), layerName(MapLayer::Grid));
        QCOMPARE(edits[0][1].toByteArray(), first);
        QCOMPARE(edits[0][2].toByteArray(), layers.saveState());
        QVERIFY(layers.restoreState(first));
        QCOMPARE(edits.count(), 1);
        grid->click();
        QCOMPARE(edits[1][1].toByteArray(), first); // And not the state before it was restored.
    }
};

USAR_TEST(tst_LayoutKeeper)

} // namespace tst_layout_keeper

#include "tst_layout_keeper.moc"
