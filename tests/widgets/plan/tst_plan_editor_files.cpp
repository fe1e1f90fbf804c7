// The plan editor's files, exports and pieces, and what a drop of each would do; its looks.
#include <QAbstractButton>
#include <QDir>
#include <QFile>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include "tests/suite/suite.h"
#include "tests/widgets/plan_editor_samples.h"
#include "widgets/plan/editor/plan_editor.h"
#include "widgets/style/theme.h"

namespace tst_plan_editor_files {

using namespace usar;
using namespace usar::widgets;

class tst_PlanEditorFiles : public QObject {
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void everyDropLeavesASoundPlanOrIsRefused();
    void paletteIsSearchedAndExplains();
    void filesKeepTheirLineEnds();
    void aChangeOnDiskIsOffered();
    void unsavedTextIsKeptAndOffered();
    void exportsSayWhatIsLost();
    void narrowAndBothThemes();
    void everyButtonHasAName();
    void applyingNeedsASoundPlan();
    void unsavedChangesAreAskedAbout_data();
    void unsavedChangesAreAskedAbout();
    void theNewestWishFollowsTheAnswer();

private:
    std::unique_ptr<PlanEditor> editor_;
};

void tst_PlanEditorFiles::init() {
    editor_ = std::make_unique<PlanEditor>();
    editor_->setText(std::string(courier_plan), QStringLiteral("courier.lap"));
    editor_->show();
    QVERIFY(QTest::qWaitForWindowExposed(editor_.get()));
}

void tst_PlanEditorFiles::cleanup() {
    editor_.reset();
}

/// Every part and every kind of piece, over every card, at every third of it.
void tst_PlanEditorFiles::everyDropLeavesASoundPlanOrIsRefused() {
    const std::string text(courier_plan);
    const posh::Plan plan = posh::readPlan(text).plan;
    const PlanTree tree(plan);
    const PlanGestures gestures(text, plan, tree);
    std::vector<std::variant<PlanPiece, PlanNodeId>> sources{PlanPiece{true, QStringLiteral("Distance 0.0 >")},
                                                             PlanPiece{false, QStringLiteral("DriveTo(\"x\")")},
                                                             PlanPiece{false, QStringLiteral("no act (")}};
    for (const PlanNodeId node : tree.nodes())
        sources.emplace_back(node);
    int done = 0;
    for (const auto& source : sources)
        for (const PlanNodeId target : planNodes(-1, tree.size()))
            for (const DropZone zone : {DropZone::Before, DropZone::Onto, DropZone::After}) {
                const auto deed = gestures.drop(source, target, zone);
                const auto edit = deed ? deed->edit() : Result<posh::PlanEdit>();
                if (!deed || !edit)
                    continue;
                ++done;
                QVERIFY(!deed->words.isEmpty());
                if (posh::hasErrors(posh::readPlan(edit->text).findings))
                    QFAIL(qPrintable(deed->words + u'\n' + QString::fromStdString(edit->text)));
            }
    QVERIFY2(done > 500, qPrintable(QString::number(done)));
}

void tst_PlanEditorFiles::paletteIsSearchedAndExplains() {
    editor_->setPrimitives(courierPrimitives());
    PlanPalette& palette = editor_->palette();
    palette.findChild<QLineEdit*>()->setText(QStringLiteral("drives place"));
    auto* const list = palette.findChild<QTreeWidget*>();
    QStringList shown;
    QString help;
    for (QTreeWidgetItemIterator item(list); *item; ++item)
        if ((*item)->parent() && !(*item)->isHidden()) {
            shown << (*item)->text(0);
            help = (*item)->toolTip(0);
        }
    QCOMPARE(shown, QStringList{QStringLiteral("DriveTo")});
    QVERIFY2(help.contains(QStringLiteral("$speed=1.0: a number from 0 to 3 m/s")), qPrintable(help));
    palette.findChild<QLineEdit*>()->clear();
    QVERIFY(std::ranges::any_of(palette.words(), [](const PlanWord& word) { return word.name == u"approach"; }));
    list->setCurrentItem(list->findItems("Distance", Qt::MatchExactly | Qt::MatchRecursive).value(0));
    QCOMPARE(palette.chosen()->words, QStringLiteral("Distance 0.0 >"));
}

void tst_PlanEditorFiles::filesKeepTheirLineEnds() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("dos.lap"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    const QByteArray bytes("\xef\xbb\xbf(\r\n  (DC d (drives ((e \"\xc2\xa0\" doNothing))))\r\n)\r\n");
    QByteArray good = bytes;
    good.replace("e \"\xc2\xa0\" doNothing", "e doNothing \"\xc2\xa0\"");
    file.write(good);
    file.close();
    QVERIFY(editor_->open(path));
    QVERIFY(editor_->findings().empty());
    QVERIFY(editor_->text().find('\r') == std::string::npos);
    QVERIFY(editor_->save(path));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), good);
    QVERIFY(!editor_->open(folder.filePath(QStringLiteral("none.lap"))));
    QVERIFY(!editor_->save(folder.filePath(QStringLiteral("no/such/folder.lap"))));
}

void tst_PlanEditorFiles::aChangeOnDiskIsOffered() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("plan.lap"));
    QVERIFY(editor_->save(path));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("((DC other (drives ((e doNothing)))))");
    file.close();
    QToolButton* take = nullptr;
    QTRY_VERIFY([&] {
        for (QToolButton* const button : editor_->findChildren<QToolButton*>())
            take = button->isVisible() && button->text() == u"Use its text" ? button : take;
        return take != nullptr;
    }());
    take->click();
    QVERIFY(editor_->text().find("other") != std::string::npos);
    editor_->textEdit().undo();
    QCOMPARE(editor_->text(), std::string(courier_plan));
}

void tst_PlanEditorFiles::unsavedTextIsKeptAndOffered() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("plan.lap"));
    editor_->setKeepingFolder(folder.filePath(QStringLiteral("kept")));
    QVERIFY(editor_->save(path));
    editor_->textEdit().applyText("((DC other (drives ((e doNothing)))))");
    const std::string changed = editor_->text();
    QTRY_VERIFY_WITH_TIMEOUT(!QDir(folder.filePath(QStringLiteral("kept"))).entryList(QDir::Files).isEmpty(), 5000);
    PlanEditor second;
    second.setKeepingFolder(folder.filePath(QStringLiteral("kept")));
    QVERIFY(second.open(path));
    QCOMPARE(second.text(), std::string(courier_plan));
    for (QToolButton* const button : second.findChildren<QToolButton*>())
        if (button->text() == u"Restore them")
            button->click();
    QCOMPARE(second.text(), changed);
    QVERIFY(second.save(path));
    QVERIFY(QDir(folder.filePath(QStringLiteral("kept"))).entryList(QDir::Files).isEmpty());
}

void tst_PlanEditorFiles::exportsSayWhatIsLost() {
    QTemporaryDir folder;
    const auto losses = editor_->exportTo(folder.filePath(QStringLiteral("k.lap")), posh::Dialect::Classic);
    QVERIFY(losses && !losses->isEmpty());
    QVERIFY(QFile::exists(folder.filePath(QStringLiteral("k.lap"))));
    QVERIFY(editor_->savePicture(folder.filePath(QStringLiteral("plan.svg"))));
    editor_->textEdit().applyText("((");
    QVERIFY(!editor_->exportTo(folder.filePath(QStringLiteral("x.lap")), posh::Dialect::Yaposh));
}

void tst_PlanEditorFiles::narrowAndBothThemes() {
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
        applyTheme(theme);
        for (const QSize size : {QSize(360, 700), QSize(1280, 720), QSize(300, 240)}) {
            editor_->resize(size);
            QVERIFY(!editor_->grab().isNull());
            QCOMPARE(editor_->size(), size);
        }
    }
}

void tst_PlanEditorFiles::everyButtonHasAName() {
    for (const QAbstractButton* const button : editor_->findChildren<QAbstractButton*>())
        if (button->isVisible() && !qobject_cast<QLineEdit*>(button->parent()))
            QVERIFY2(!button->accessibleName().isEmpty() || !button->text().isEmpty(), qPrintable(button->toolTip()));
}

void tst_PlanEditorFiles::applyingNeedsASoundPlan() {
    QSignalSpy applied(editor_.get(), &PlanEditor::applyRequested);
    QAction* const apply = editor_->action(QStringLiteral("apply"));
    QVERIFY(!apply->isEnabled());
    editor_->setApplicable(true);
    QVERIFY(apply->isEnabled());
    apply->trigger();
    QCOMPARE(applied.count(), 1);
    QCOMPARE(applied[0][1].toString(), QStringLiteral("courier.lap"));
    editor_->textEdit().applyText("((AP a (b)))");
    editor_->catchUp();
    QVERIFY(!apply->isEnabled());
}

void tst_PlanEditorFiles::unsavedChangesAreAskedAbout_data() {
    QTest::addColumn<int>("answer");
    QTest::addColumn<bool>("goes_on");
    QTest::addColumn<bool>("written");
    QTest::newRow("save") << int(QMessageBox::Save) << true << true;
    QTest::newRow("discard") << int(QMessageBox::Discard) << true << false;
    QTest::newRow("cancel") << int(QMessageBox::Cancel) << false << false;
}

void tst_PlanEditorFiles::unsavedChangesAreAskedAbout() {
    QFETCH(int, answer);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("plan.lap"));
    QVERIFY(editor_->save(path));
    int went_on = 0;
    editor_->letGo([&] { ++went_on; });
    QCOMPARE(went_on, 1);
    editor_->textEdit().applyText("((DC other (drives ((e doNothing)))))");
    editor_->letGo([&] { ++went_on; });
    QCOMPARE(went_on, 1);
    auto* const box = editor_->findChild<QMessageBox*>();
    QVERIFY(box && !box->isModal());
    box->button(static_cast<QMessageBox::StandardButton>(answer))->click();
    QTEST(went_on == 2, "goes_on");
    QCOMPARE(editor_->isModified(), went_on == 1);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QTEST(file.readAll().contains("DC other"), "written");
}

void tst_PlanEditorFiles::theNewestWishFollowsTheAnswer() {
    editor_->textEdit().applyText("((DC other (drives ((e doNothing)))))");
    QStringList went_on;
    editor_->letGo([&] { went_on << QStringLiteral("first"); });
    editor_->letGo([&] { went_on << QStringLiteral("second"); });
    const auto boxes = editor_->findChildren<QMessageBox*>();
    QCOMPARE(boxes.size(), 1);
    boxes.front()->button(QMessageBox::Discard)->click();
    QCOMPARE(went_on, QStringList(QStringLiteral("second")));
}

USAR_TEST(tst_PlanEditorFiles)

} // namespace tst_plan_editor_files

#include "tst_plan_editor_files.moc"
