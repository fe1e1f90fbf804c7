// The plan editor by mouse and keys: text and drawing in step, one history, findings and their mends.
#include <QAbstractItemView>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/posh/edit/plan_phrase.h"
#include "tests/suite/suite.h"
#include "tests/widgets/plan_editor_samples.h"
#include "widgets/messages/completion_delegate.h"
#include "widgets/plan/editor/plan_editor.h"
#include "widgets/plan/editor/plan_values_dialog.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/theme.h"

namespace tst_plan_editor {

using namespace usar;
using namespace usar::widgets;

class tst_PlanEditor : public QObject {
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void aNewPlanIsSoundAndDrawn();
    void typingIsDrawnAndUndone();
    void errorsKeepTheDrawingAndRefuseEditsOfIt();
    void oneHistoryForTextAndDrawing();
    void historySurvivesSaving();
    void renamingTakesAllReferencesAlong();
    void keysMoveAddAndDelete();
    void wordsAreChangedWhereTheyStand();
    void valuesAreChangedInTheirDialog();
    void realTimeThatIsNotKeptIsSaid();
    void neighborsAreWrappedTogether();
    void whatFailsIsSaid();
    void bindingIsCheckedAgainstTheRobot();
    void aFixIsAppliedFromTheMenu();
    void piecesAreAddedFromThePalette();
    void dropsSwapAndInsert_data();
    void dropsSwapAndInsert();
    void commandsThatMeanNothingAreOff();
    void anEditLeavesTheDrawingWhereItIs();
    void completionKnowsWhereSensesAreAsked();
    void selectionsFollowEachOther();
    void differencesAreListed();
    void usagesAreListed();
    void emptyListsSayHowTheyAreFilled();
    void keysOfAWindowAroundItDoNotGetInTheWay();
    void twoAreSwappedByKeys();
    void aLampShowsThatThereAreFixes();
    void noRunOfEditsEndsInErrors();

private:
    PlanNodeId node(const QString& name) const;
    void select(const QString& name) { editor_->canvas().select(node(name)); }
    void run(const char* command) { editor_->action(QString::fromLatin1(command))->trigger(); }
    QString said() const;
    void drag(const QMimeData& data, PlanNodeId target, double share);
    std::unique_ptr<PlanEditor> editor_;
};

void tst_PlanEditor::init() {
    applyTheme(Theme::Dark);
    editor_ = std::make_unique<PlanEditor>();
    editor_->resize(1280, 720);
    editor_->setText(std::string(courier_plan), QStringLiteral("courier.lap"));
    editor_->show();
    QVERIFY(QTest::qWaitForWindowExposed(editor_.get()));
}

void tst_PlanEditor::cleanup() {
    editor_.reset();
}

PlanNodeId tst_PlanEditor::node(const QString& name) const {
    const PlanTree& tree = editor_->canvas().tree();
    for (const PlanNodeId node : tree.nodes())
        if (tree[node].name == name && !tree[node].link.valid())
            return node;
    return {};
}

QString tst_PlanEditor::said() const {
    for (const QLabel* const label : editor_->findChildren<QLabel*>())
        if (label->property("role") == "danger" && label->isVisible())
            return label->text();
    return {};
}

/// As if a piece came from the palette: over the card, and let go at that share of its height.
void tst_PlanEditor::drag(const QMimeData& data, PlanNodeId target, double share) {
    PlanCanvas& canvas = editor_->canvas();
    const QRectF box = canvas.layout().box(canvas.tree(), target);
    const QPoint at = canvas.toScreen({box.left() + 30.0, box.top() + share * box.height()}).toPoint();
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&canvas, &enter);
    QDragMoveEvent move(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&canvas, &move);
    QDropEvent drop(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&canvas, &drop);
}

void tst_PlanEditor::aNewPlanIsSoundAndDrawn() {
    PlanEditor fresh;
    QVERIFY(fresh.findings().empty());
    QVERIFY(!fresh.isModified());
    QVERIFY(!fresh.canvas().tree().empty());
    fresh.setPrimitives(courierPrimitives());
    QVERIFY(fresh.findings().empty());
}

void tst_PlanEditor::typingIsDrawnAndUndone() {
    PlanCodeEdit& text = editor_->textEdit();
    putCursor(text, editor_->text().find("Beep") + 4);
    QTest::keyClicks(&text, QStringLiteral("Twice"));
    QTRY_VERIFY(node(QStringLiteral("BeepTwice")).valid());
    QVERIFY(editor_->isModified());
    run("undo");
    QTRY_VERIFY(!node(QStringLiteral("BeepTwice")).valid());
    QCOMPARE(QString::fromStdString(editor_->text()),
             QString::fromUtf8(courier_plan.data(), qsizetype(courier_plan.size())));
}

void tst_PlanEditor::errorsKeepTheDrawingAndRefuseEditsOfIt() {
    const int nodes = editor_->canvas().tree().size();
    editor_->textEdit().applyText("((AP a (b)");
    editor_->catchUp();
    QVERIFY(posh::hasErrors(editor_->findings()));
    QCOMPARE(editor_->canvas().tree().size(), nodes);
    select(QStringLiteral("safety"));
    run("delete");
    QCOMPARE(editor_->text(), std::string("((AP a (b)"));
    editor_->textEdit().applyText("((AP a (b)))");
    editor_->catchUp();
    QVERIFY(node(QStringLiteral("a")).valid());
}

void tst_PlanEditor::oneHistoryForTextAndDrawing() {
    const std::string first = editor_->text();
    select(QStringLiteral("work"));
    run("move_up");
    const std::string second = editor_->text();
    QVERIFY(second != first);
    QCOMPARE(editor_->canvas().selected(), node(QStringLiteral("work")));
    putCursor(editor_->textEdit(), 2); // after the first parentheses
    QTest::keyClicks(&editor_->textEdit(), QStringLiteral("; x"));
    const std::string third = editor_->text();
    select(QStringLiteral("rest"));
    editor_->catchUp();
    run("duplicate");
    run("undo");
    QCOMPARE(editor_->text(), third);
    run("undo");
    QCOMPARE(editor_->text(), second);
    run("undo");
    QCOMPARE(editor_->text(), first);
    run("redo");
    QCOMPARE(editor_->text(), second);
}

void tst_PlanEditor::historySurvivesSaving() {
    QTemporaryDir folder;
    const std::string first = editor_->text();
    for (int i = 0; i < 300; ++i) {
        select(QStringLiteral("work"));
        run(i % 2 == 0 ? "move_up" : "move_down");
    }
    QVERIFY(editor_->save(folder.filePath("a.lap")));
    QVERIFY(!editor_->isModified());
    for (int i = 0; i < 300; ++i)
        run("undo");
    QCOMPARE(editor_->text(), first);
    QVERIFY(editor_->isModified());
}

void tst_PlanEditor::renamingTakesAllReferencesAlong() {
    select(QStringLiteral("halt"));
    run("rename");
    QLineEdit* const line = editor_->canvas().openLine();
    QVERIFY(line);
    QCOMPARE(line->text(), QStringLiteral("halt"));
    QTest::keyClicks(line, QStringLiteral("freeze"));
    QTest::keyClick(line, Qt::Key_Return);
    QVERIFY(editor_->text().find("halt") == std::string::npos);
    QVERIFY(editor_->text().find("(AP freeze (Stop Brake))") != std::string::npos);
    QVERIFY(editor_->text().find("freeze (seconds 2)") != std::string::npos);
    QCOMPARE(editor_->canvas().selected(), node(QStringLiteral("freeze")));
    QVERIFY(editor_->canvas().hasFocus()); // the key did not go on to the drawing
}

void tst_PlanEditor::keysMoveAddAndDelete() {
    PlanCanvas& canvas = editor_->canvas();
    canvas.setFocus();
    select(QStringLiteral("grab"));
    QTest::keyClick(&canvas, Qt::Key_Delete);
    QVERIFY(!node(QStringLiteral("grab")).valid());
    select(QStringLiteral("safety"));
    QTest::keyClick(&canvas, Qt::Key_Insert);
    QVERIFY(canvas.openLine());
    QTest::keyClicks(canvas.openLine(), QStringLiteral("Brake"));
    QTest::keyClick(canvas.openLine(), Qt::Key_Return);
    QVERIFY2(editor_->text().find("((doNothing (trigger ((fail))) Brake))") != std::string::npos,
             editor_->text().c_str());
}

void tst_PlanEditor::wordsAreChangedWhereTheyStand() {
    PlanCanvas& canvas = editor_->canvas();
    const auto enter = [&](const QString& words) {
        QVERIFY(canvas.openLine());
        canvas.openLine()->selectAll();
        QTest::keyClicks(canvas.openLine(), words);
        QTest::keyClick(canvas.openLine(), Qt::Key_Return);
    };
    select(QStringLiteral("Bumped"));
    run("edit");
    enter(QStringLiteral("Distance 0.1 <"));
    QVERIFY(editor_->text().find("(trigger ((Distance 0.1 <))) halt") != std::string::npos);
    select(QStringLiteral("work"));
    run("trigger");
    QCOMPARE(canvas.openLine()->text(), QStringLiteral("(Battery 0.2 >) (Bumped false)"));
    enter(QStringLiteral("(Battery 0.5 >)"));
    QVERIFY(editor_->text().find("(trigger ((Battery 0.5 >))) fetch") != std::string::npos);
    select(QStringLiteral("safety"));
    run("limit");
    QCOMPARE(canvas.openLine()->text(), QStringLiteral("seconds 2"));
    enter(QStringLiteral("hz 4"));
    QVERIFY(editor_->text().find("halt (hz 4)") != std::string::npos);
    run("comment");
    enter(QStringLiteral("first of all"));
    QVERIFY(editor_->text().find("\"first of all\"") != std::string::npos);
    run("edit");
    QTest::keyClicks(canvas.openLine(), QStringLiteral("nothing of this"));
    QTest::keyClick(canvas.openLine(), Qt::Key_Escape);
    QVERIFY(node(QStringLiteral("safety")).valid());
}

void tst_PlanEditor::valuesAreChangedInTheirDialog() {
    editor_->setPrimitives(courierPrimitives());
    select("Battery");
    QVERIFY(editor_->action("values")->isEnabled());
    run("values");
    auto* const dialog = editor_->findChild<PlanValuesDialog*>();
    QVERIFY(dialog && dialog->isVisible());
    const QString before = QString::fromStdString(posh::phraseOf(dialog->test()));
    auto* const box = dialog->findChild<QuantityBox*>();
    QVERIFY(box);
    box->setValue(0.75);
    const QString after = QString::fromStdString(posh::phraseOf(dialog->test()));
    QVERIFY(before != after && after.contains("0.75"));
    dialog->accept();
    QVERIFY2(editor_->text().find('(' + after.toStdString()) != std::string::npos, editor_->text().c_str());
    QVERIFY(!posh::hasErrors(editor_->findings()));
    run("undo");
    QCOMPARE(editor_->text(), std::string(courier_plan));
    editor_->canvas().select({});
    QVERIFY(!editor_->action("values")->isEnabled());
}

void tst_PlanEditor::realTimeThatIsNotKeptIsSaid() {
    const auto says = [this] {
        const auto labels = editor_->findChildren<QLabel*>();
        return std::ranges::any_of(labels, [](const QLabel* label) { return label->text().contains("real time"); });
    };
    editor_->setPrimitives(courierPrimitives());
    editor_->setText("((DC d (drives ((e Stop)))))", QStringLiteral("a.lap"));
    QVERIFY(!says());
    editor_->setText("((SRDC d (drives ((e Stop)))))", QStringLiteral("b.lap"));
    QVERIFY(says());
    QVERIFY(editor_->findings().empty()); // it is no fault
    QVERIFY2(editor_->textEdit().toolTipAt(1).contains("N501"), qPrintable(editor_->textEdit().toolTipAt(1)));
    const auto lists = editor_->findChildren<QListWidget*>();
    const auto list = std::ranges::find(lists, QStringLiteral("Problems"), &QListWidget::accessibleName);
    QVERIFY(list != lists.end());
    QCOMPARE((*list)->count(), 1);
    QCOMPARE((*list)->item(0)->text(), editor_->textEdit().toolTipAt(1));
}

void tst_PlanEditor::neighborsAreWrappedTogether() {
    editor_->setText("((AP go (Stop Brake Rest)) (DC d (drives ((e go)))))", QStringLiteral("go.lap"));
    select("Stop");
    PlanCanvas& canvas = editor_->canvas();
    canvas.setFocus();
    QTest::keyClick(&canvas, Qt::Key_Down, Qt::ShiftModifier);
    QCOMPARE(canvas.range(), (std::vector<PlanNodeId>{node("Stop"), node("Brake")}));
    QTest::keyClick(&canvas, Qt::Key_Down, Qt::ShiftModifier);
    QCOMPARE(canvas.range().size(), std::size_t(3));
    QTest::keyClick(&canvas, Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY(editor_->action("wrap_pattern")->isEnabled() && !editor_->action("wrap_adopt")->isEnabled());
    run("wrap_pattern");
    QVERIFY2(editor_->text().find("(AP do-Stop (Stop Brake))") != std::string::npos, editor_->text().c_str());
    QVERIFY2(editor_->text().find("(AP go (do-Stop Rest))") != std::string::npos, editor_->text().c_str());
    run("undo");
    select("Rest");
    QCOMPARE(canvas.range().size(), std::size_t(1));
    const QPointF brake = canvas.layout().box(canvas.tree(), node("Brake")).topLeft() + QPointF(20.0, 10.0);
    QTest::mouseClick(&canvas, Qt::LeftButton, Qt::ShiftModifier, canvas.toScreen(brake).toPoint());
    QCOMPARE(canvas.range(), (std::vector<PlanNodeId>{node("Brake"), node("Rest")}));
    select("Stop");
    QCOMPARE(canvas.range(), std::vector<PlanNodeId>{node("Stop")});
}

void tst_PlanEditor::whatFailsIsSaid() {
    select(QStringLiteral("halt"));
    run("delete");
    QVERIFY2(said().contains(QStringLiteral("called in line")), qPrintable(said()));
    select(QStringLiteral("fetch"));
    run("rename");
    QTest::keyClicks(editor_->canvas().openLine(), QStringLiteral("halt"));
    QTest::keyClick(editor_->canvas().openLine(), Qt::Key_Return);
    QVERIFY2(said().contains(QStringLiteral("taken")), qPrintable(said()));
}

void tst_PlanEditor::bindingIsCheckedAgainstTheRobot() {
    editor_->setPrimitives(courierPrimitives());
    QVERIFY2(!posh::hasErrors(editor_->findings()),
             editor_->findings().empty() ? "" : toText(editor_->findings().front()).c_str());
    std::string other(courier_plan);
    other.replace(other.find("Brake"), 5, "Broke");
    editor_->textEdit().applyText(other);
    editor_->catchUp();
    QCOMPARE(editor_->findings().back().code, posh::Code::UnknownPrimitive);
    int rows = 0;
    for (const QListWidget* const list : editor_->findChildren<QListWidget*>())
        rows += list->accessibleName() == u"Problems" ? list->count() : 0;
    QCOMPARE(std::size_t(rows), editor_->findings().size());
}

void tst_PlanEditor::aFixIsAppliedFromTheMenu() {
    editor_->setPrimitives(courierPrimitives());
    std::string other(courier_plan);
    other.replace(other.find("Brake"), 5, "Broke");
    editor_->textEdit().applyText(other);
    putCursor(editor_->textEdit(), other.find("Broke"));
    editor_->textEdit().setFocus();
    QVERIFY(!editor_->fixes().empty());
    QTest::keyClick(&editor_->textEdit(), Qt::Key_Return, Qt::AltModifier);
    QMenu* menu = nullptr;
    for (QMenu* const candidate : editor_->textEdit().findChildren<QMenu*>())
        menu = candidate->isVisible() ? candidate : menu;
    QVERIFY(menu && menu->actions().front()->text() == QStringLiteral("Write Brake"));
    menu->actions().front()->trigger();
    QCOMPARE(editor_->text(), std::string(courier_plan));
    run("undo");
    QCOMPARE(editor_->text(), other);
}

void tst_PlanEditor::piecesAreAddedFromThePalette() {
    editor_->setPrimitives(courierPrimitives());
    select(QStringLiteral("rest"));
    emit editor_->palette().pieceRequested({true, QStringLiteral("Distance 0.0 >")});
    QVERIFY2(editor_->text().find("((rest (trigger ((Distance 0.0 >))) wait))") != std::string::npos,
             editor_->text().c_str());
    select(QStringLiteral("halt"));
    emit editor_->palette().pieceRequested({false, QStringLiteral("Beep")});
    QVERIFY2(editor_->text().find("(AP halt (Stop Brake Beep))") != std::string::npos, editor_->text().c_str());
    editor_->canvas().select({});
    emit editor_->palette().pieceRequested({false, QStringLiteral("approach")});
    QVERIFY(editor_->text().find("((approach approach))") != std::string::npos);
    QVERIFY(!posh::hasErrors(editor_->findings()));
}

void tst_PlanEditor::dropsSwapAndInsert_data() {
    QTest::addColumn<QString>("piece");
    QTest::addColumn<QString>("target");
    QTest::addColumn<double>("share");
    QTest::addColumn<QString>("outcome");
    QTest::newRow("an act before a drive") << "Beep"
                                           << "work" << 0.05 << "((Beep   (trigger ((fail))) Beep))\n      ((work";
    QTest::newRow("an act on a drive") << "Beep"
                                       << "work" << 0.5 << "(Bumped false))) Beep)";
    QTest::newRow("an act after a step") << "Beep"
                                         << "Stop" << 0.95 << "(AP halt (Stop Beep Brake))";
    QTest::newRow("an act in place of a step") << "Beep"
                                               << "Stop" << 0.5 << "(AP halt (Beep Brake))";
    QTest::newRow("a sense on an element") << "sense:Bumped"
                                           << "go" << 0.5 << "(go (trigger ((Bumped))) DriveTo";
    QTest::newRow("a sense in place of one") << "sense:Loaded"
                                             << "Bumped" << 0.5 << "(safety (trigger ((Loaded))) halt";
    QTest::newRow("a drive after another") << "node:safety"
                                           << "work" << 0.95 << "(Bumped false))) fetch))\n      ((safety";
    QTest::newRow("two drives") << "node:safety"
                                << "work" << 0.5 << "(Bumped false))) fetch))\n      ((safety";
    QTest::newRow("two acts") << "node:Stop"
                              << "Brake" << 0.5 << "(AP halt (Brake Stop))";
    QTest::newRow("an act of a pattern and one of an element") << "node:Stop"
                                                               << "CloseGripper" << 0.5 << "(Loaded false))) Stop 3";
    QTest::newRow("a sense moves to another") << "node:Bumped"
                                              << "go" << 0.5 << "(go (trigger ((Bumped))) DriveTo";
    QTest::newRow("an element into the collection") << "node:go"
                                                    << "courier" << 0.5 << "((go     DriveTo(\"depot\", $speed=1.5)))";
}

void tst_PlanEditor::dropsSwapAndInsert() {
    QFETCH(QString, piece);
    QFETCH(QString, target);
    QFETCH(double, share);
    QFETCH(QString, outcome);
    std::unique_ptr<QMimeData> data;
    if (piece.startsWith(QStringLiteral("node:"))) {
        data = std::make_unique<QMimeData>();
        data->setData(QStringLiteral("application/x-usar-plan-node"), QByteArray::number(node(piece.mid(5)).value));
    } else {
        const bool is_sense = piece.startsWith(QStringLiteral("sense:"));
        data.reset(mimeOf({is_sense, is_sense ? piece.mid(6) : piece}));
    }
    drag(*data, node(target), share);
    QVERIFY2(editor_->text().find(outcome.toStdString()) != std::string::npos,
             (editor_->text() + said().toStdString()).c_str());
    QVERIFY(!posh::hasErrors(editor_->findings()));
    run("undo");
    QCOMPARE(editor_->text(), std::string(courier_plan));
}

void tst_PlanEditor::anEditLeavesTheDrawingWhereItIs() {
    PlanCanvas& canvas = editor_->canvas();
    select(QStringLiteral("safety"));
    const double scale = canvas.scale();
    const QPointF corner = canvas.toLayout({0.0, 0.0});
    run("duplicate");
    QCOMPARE(canvas.scale(), scale);
    QCOMPARE(canvas.toLayout({0.0, 0.0}), corner);
}

void tst_PlanEditor::commandsThatMeanNothingAreOff() {
    const auto isOn = [this](const char* name) { return editor_->action(QString::fromLatin1(name))->isEnabled(); };
    editor_->canvas().select({});
    QVERIFY(!isOn("edit") && !isOn("delete") && !isOn("swap") && isOn("new_pattern") && !isOn("new_collection"));
    select(QStringLiteral("safety"));
    QVERIFY(isOn("edit") && isOn("trigger") && isOn("limit") && isOn("wrap_pattern") && isOn("join_down"));
    QVERIFY(!isOn("inline"));
    select(QStringLiteral("halt"));
    QVERIFY(isOn("inline") && !isOn("trigger") && isOn("add_after"));
    select(QStringLiteral("Bumped"));
    QVERIFY(isOn("edit") && !isOn("limit") && !isOn("wrap_pattern"));
    QVERIFY(!isOn("compare_running"));
}

void tst_PlanEditor::completionKnowsWhereSensesAreAsked() {
    editor_->setPrimitives(courierPrimitives());
    PlanCodeEdit& text = editor_->textEdit();
    auto* const completer = text.findChild<QCompleter*>();
    text.setFocus();
    putCursor(text, editor_->text().find("Bumped") + 2);
    QTest::keyClick(&text, Qt::Key_Space, Qt::ControlModifier);
    QCOMPARE(completer->currentCompletion(), QStringLiteral("Bumped"));
    putCursor(text, editor_->text().find("CloseGripper") + 2);
    QTest::keyClick(&text, Qt::Key_Space, Qt::ControlModifier);
    QCOMPARE(completer->currentCompletion(), QStringLiteral("CloseGripper"));
    const auto* const beside = qobject_cast<const CompletionDelegate*>(completer->popup()->itemDelegate());
    QVERIFY(beside); // paints the documentation
    const QModelIndex first = completer->completionModel()->index(0, 0);
    QCOMPARE(first.data(CompletionDelegate::help_role).toString(), QStringLiteral("Does it."));
}

void tst_PlanEditor::selectionsFollowEachOther() {
    PlanCodeEdit& text = editor_->textEdit();
    putCursor(text, editor_->text().find("safety") + 1);
    QCOMPARE(editor_->canvas().selected(), node(QStringLiteral("safety")));
    QSignalSpy entered(&text, &PlanTextEdit::placeEntered);
    select(QStringLiteral("go"));
    QCOMPARE(text.textCursor().blockNumber(), 6);
    QCOMPARE(entered.count(), 0);
    const auto marked = text.extraSelections().size();
    text.moveCursor(QTextCursor::Down); // the person goes on in the text
    QCOMPARE(text.extraSelections().size(), marked - 1);
}

void tst_PlanEditor::differencesAreListed() {
    editor_->setRunningPlan(QStringLiteral("R1"), std::string(courier_plan));
    select(QStringLiteral("grab"));
    run("delete");
    run("compare_running");
    QStringList rows;
    for (const QListWidget* const list : editor_->findChildren<QListWidget*>())
        for (int i = 0; list->accessibleName() == u"Differences" && i < list->count(); ++i)
            rows << list->item(i)->text();
    QCOMPARE(rows, QStringList{QStringLiteral("element \"grab\" of \"fetch\" removed")});
}

void tst_PlanEditor::usagesAreListed() {
    select(QStringLiteral("halt"));
    run("usages");
    int rows = 0;
    for (const QListWidget* const list : editor_->findChildren<QListWidget*>())
        rows += list->accessibleName() == u"Usages" ? list->count() : 0;
    QCOMPARE(rows, 3);
}

void tst_PlanEditor::emptyListsSayHowTheyAreFilled() {
    const auto sheet = [this](const QString& title) {
        for (EmptyState* each : editor_->findChildren<EmptyState*>())
            if (each->accessibleName() == title)
                return !each->isHidden();
        return false;
    };
    QCOMPARE(sheet("No problems"), editor_->findings().empty());
    QVERIFY(sheet("Nothing compared yet") && sheet("No usages listed"));
    editor_->setRunningPlan(QStringLiteral("R1"), std::string(courier_plan));
    run("compare_running");
    QVERIFY(!sheet("Nothing compared yet"));
    select(QStringLiteral("halt"));
    run("usages");
    QVERIFY(!sheet("No usages listed"));
    editor_->setText("((DC d (drives ((e Stop)))", QStringLiteral("a.lap"));
    QVERIFY(!editor_->findings().empty());
    QTRY_VERIFY(!sheet("No problems"));
    editor_->setText("((DC d (drives ((e Stop)))))", QStringLiteral("b.lap"));
    QVERIFY(editor_->findings().empty());
    QTRY_VERIFY(sheet("No problems"));
}

void tst_PlanEditor::keysOfAWindowAroundItDoNotGetInTheWay() {
    QWidget window;
    QStringList taken;
    for (const char* const keys : {"Ctrl+Z", "Alt+Down", "L", "F8", "Ctrl+S", "F"}) {
        auto* action = new QAction(&window);
        action->setShortcut(QKeySequence(QString::fromLatin1(keys)));
        connect(action, &QAction::triggered, &window, [&taken, keys] { taken << QString::fromLatin1(keys); });
        window.addAction(action);
    }
    editor_->setParent(&window);
    window.resize(1280, 720);
    window.show();
    editor_->show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    PlanCanvas& canvas = editor_->canvas();
    canvas.setFocus();
    select(QStringLiteral("safety"));
    QTest::keyClick(&canvas, Qt::Key_Down, Qt::AltModifier);
    QVERIFY(editor_->text() != std::string(courier_plan));
    QTest::keyClick(&canvas, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(editor_->text(), std::string(courier_plan));
    select(QStringLiteral("safety"));
    QTest::keyClick(&canvas, Qt::Key_F);
    QTest::keyClick(&canvas, Qt::Key_L);
    QVERIFY(canvas.openLine());
    QTest::keyClick(canvas.openLine(), Qt::Key_Escape);
    editor_->textEdit().setFocus();
    QTest::keyClick(&editor_->textEdit(), Qt::Key_F8);
    QTest::keyClick(&editor_->textEdit(), Qt::Key_S, Qt::ControlModifier);
    QVERIFY(editor_->findChild<QFileDialog*>(QStringLiteral("Save plan"))); // It has no file yet.
    QCOMPARE(taken, QStringList());
    editor_->setParent(nullptr);
}

void tst_PlanEditor::twoAreSwappedByKeys() {
    PlanCanvas& canvas = editor_->canvas();
    canvas.setFocus();
    select(QStringLiteral("Stop"));
    QTest::keyClick(&canvas, Qt::Key_X);
    select(QStringLiteral("CloseGripper"));
    QTest::keyClick(&canvas, Qt::Key_X);
    QVERIFY2(editor_->text().find("(AP halt (CloseGripper Brake))") != std::string::npos, editor_->text().c_str());
}

void tst_PlanEditor::aLampShowsThatThereAreFixes() {
    PlanCodeEdit& text = editor_->textEdit();
    std::string other(courier_plan);
    other.replace(other.find("(trigger ((Bumped)))"), 8, "(triger");
    text.applyText(other);
    putCursor(text, other.find("(triger"));
    const auto lampIsOn = [&text] {
        for (const QToolButton* const button : text.findChildren<QToolButton*>())
            if (button->toolTip().contains(u"Alt+Return"))
                return button->isVisible();
        return false;
    };
    QTRY_VERIFY(lampIsOn());
    putCursor(text, 0);
    QVERIFY(!lampIsOn());
}

/// Whatever command is given at whatever part: the text can be read afterwards, and all of it can be undone.
void tst_PlanEditor::noRunOfEditsEndsInErrors() {
    const char* const commands[] = {"move_up",         "move_down",    "join_up",    "join_down", "duplicate", "delete",
                                    "wrap_competence", "wrap_pattern", "wrap_adopt", "inline",    "undo"};
    unsigned chance = 7;
    for (int i = 0; i < 400; ++i) {
        chance = chance * 1664525U + 1013904223U;
        editor_->canvas().select({static_cast<int>((chance >> 8U) % unsigned(editor_->canvas().tree().size()))});
        run(commands[(chance >> 20U) % std::size(commands)]);
        if (posh::hasErrors(editor_->findings()))
            QFAIL((std::to_string(i) + ": " + editor_->text()).c_str());
    }
    while (editor_->action(QStringLiteral("undo"))->isEnabled())
        run("undo");
    QCOMPARE(editor_->text(), std::string(courier_plan));
}

USAR_TEST(tst_PlanEditor)

} // namespace tst_plan_editor

#include "tst_plan_editor.moc"
