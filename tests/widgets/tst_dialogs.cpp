// Files, folders and numbers are asked for beside everything else: no dialog is modal.
#include <algorithm>
#include <memory>

#include <QApplication>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QInputDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/panels/dialogs.h"
#include "widgets/panels/export_dialog.h"

namespace tst_dialogs {

using namespace usar;
using namespace usar::widgets;

namespace {

const QString title = QStringLiteral("Save plan");
const QString filters = QStringLiteral("Pictures (*.png);;Drawings (*.svg)");

/// The only visible dialog of that kind below `parent`; nullptr if there is none, or more than one.
template <class Dialog>
Dialog* shown(const QWidget& parent) {
    QList<Dialog*> dialogs = parent.findChildren<Dialog*>();
    dialogs.removeIf([](const Dialog* dialog) { return !dialog->isVisible(); });
    return dialogs.size() == 1 ? dialogs.front() : nullptr;
}

QAbstractButton* button(const QWidget& dialog, const QString& text) {
    const auto buttons = dialog.findChildren<QAbstractButton*>();
    const auto found = std::ranges::find_if(
        buttons, [&](const QAbstractButton* one) { return one->isVisible() && one->text().remove(u'&') == text; });
    return found == buttons.end() ? nullptr : *found;
}

bool click(const QWidget& dialog, const QString& text) {
    return QTest::qWaitFor([&] {
        QAbstractButton* const found = button(dialog, text);
        if (!found || !found->isEnabled())
            return false;
        QTest::mouseClick(found, Qt::LeftButton);
        return true;
    });
}

bool write(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write("old") == 3;
}

} // namespace

class tst_Dialogs : public QObject {
    Q_OBJECT
private slots:
    void init();
    void aSecondRequestRaisesTheOpenDialog();
    void anExistingFileIsReplacedOnlyAfterAQuestion();
    void suffixIsAddedOnlyWhereNoneIs_data();
    void suffixIsAddedOnlyWhereNoneIs();
    void aNewFolderCanBeMadeAndChosen();
    void aNumberIsAskedFor();
    void theLeastNumberCanHaveAMeaning();
    void formatsOfAMapAreAskedFor();

private:
    TakePath take() {
        return [this](const QString& path) { taken_ << path; };
    }

    std::unique_ptr<QWidget> window_;
    std::unique_ptr<QTemporaryDir> folder_;
    QStringList taken_;
};

void tst_Dialogs::init() {
    window_ = std::make_unique<QWidget>();
    window_->show();
    folder_ = std::make_unique<QTemporaryDir>();
    taken_.clear();
}

void tst_Dialogs::aSecondRequestRaisesTheOpenDialog() {
    const QStringList asked{"first", "second"};
    QStringList answered;
    for (const QString& who : asked)
        askWhereToSave(window_.get(), title, folder_->filePath("plan"), filters,
                       [&answered, who](const QString&) { answered << who; });
    auto* const dialog = shown<QFileDialog>(*window_);
    QVERIFY(dialog);
    QVERIFY(!dialog->isModal());
    QVERIFY(!QApplication::activeModalWidget());
    QVERIFY(click(*dialog, "Save"));
    QCOMPARE(answered, QStringList{"second"}); // Only the newest request is answered.
    QVERIFY(!shown<QFileDialog>(*window_));
}

void tst_Dialogs::anExistingFileIsReplacedOnlyAfterAQuestion() {
    const QString path = folder_->filePath("plan.png");
    QVERIFY(write(path));
    askWhereToSave(window_.get(), title, path, filters, take());
    auto* const dialog = shown<QFileDialog>(*window_);
    QVERIFY(dialog);
    QVERIFY(click(*dialog, "Save"));
    auto* question = shown<QMessageBox>(*dialog);
    QVERIFY(question);
    QVERIFY(!question->isModal());
    QVERIFY(!QApplication::activeModalWidget());
    QVERIFY2(question->text().contains("plan.png"), qPrintable(question->text()));
    QVERIFY(click(*question, "Cancel"));
    QVERIFY(dialog->isVisible());
    QVERIFY(taken_.isEmpty());
    QVERIFY(click(*dialog, "Save"));
    question = shown<QMessageBox>(*dialog);
    QVERIFY(question);
    QVERIFY(click(*question, "Replace"));
    QCOMPARE(taken_, QStringList{path});
    QVERIFY(!shown<QFileDialog>(*window_));
}

void tst_Dialogs::suffixIsAddedOnlyWhereNoneIs_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("whole");
    QTest::newRow("none") << "plan"
                          << "plan.png";
    QTest::newRow("another") << "plan.svg"
                             << "plan.svg";
}

void tst_Dialogs::suffixIsAddedOnlyWhereNoneIs() {
    QFETCH(QString, typed);
    QFETCH(QString, whole);
    QVERIFY(QDir(folder_->path()).mkdir("v1.2"));
    askWhereToSave(window_.get(), title, folder_->filePath("v1.2/") + typed, filters, take());
    auto* const dialog = shown<QFileDialog>(*window_);
    QVERIFY(dialog);
    QVERIFY(click(*dialog, "Save"));
    QCOMPARE(taken_, QStringList{folder_->filePath("v1.2/" + whole)});
}

void tst_Dialogs::aNewFolderCanBeMadeAndChosen() {
    askForFolder(window_.get(), "Folder for results", folder_->path(), take());
    auto* const dialog = shown<QFileDialog>(*window_);
    QVERIFY(dialog);
    QVERIFY(click(*dialog, "New folder…"));
    auto* const name = shown<QInputDialog>(*dialog);
    QVERIFY(name);
    QVERIFY(!QApplication::activeModalWidget());
    name->setTextValue("today");
    QVERIFY(click(*name, "OK"));
    QVERIFY(QDir(folder_->filePath("today")).exists());
    QVERIFY(click(*dialog, "Choose"));
    QCOMPARE(taken_, QStringList{folder_->filePath("today")});
}

void tst_Dialogs::aNumberIsAskedFor() {
    int number = 0;
    for (int again = 0; again < 2; ++again)
        askForNumber(window_.get(), "Image server", "Port", 5003, 1, 65535, [&number](int port) { number += port; });
    auto* const dialog = shown<QInputDialog>(*window_);
    QVERIFY(dialog);
    QVERIFY(!QApplication::activeModalWidget());
    QCOMPARE(dialog->intValue(), 5003);
    dialog->setIntValue(5010);
    QVERIFY(click(*dialog, "OK"));
    QCOMPARE(number, 5010);
}

void tst_Dialogs::theLeastNumberCanHaveAMeaning() {
    int number = -1;
    askForNumber(
        window_.get(), "Size", "Megabytes", 0, 0, 100, [&number](int megabytes) { number = megabytes; }, "no limit");
    auto* const dialog = shown<QInputDialog>(*window_);
    QVERIFY(dialog);
    auto* const box = dialog->findChild<QSpinBox*>();
    QVERIFY(box);
    QCOMPARE(box->text(), QString("no limit"));
    QTest::keyClick(box, Qt::Key_Up);
    QCOMPARE(box->text(), QString("1"));
    QTest::keyClick(box, Qt::Key_Down);
    QVERIFY(click(*dialog, "OK"));
    QCOMPARE(number, 0);
}

void tst_Dialogs::formatsOfAMapAreAskedFor() {
    ExportDialog dialog({{"tif", "GeoTIFF", "heights"}, {"ply", "PLY", "points"}, {"las", "LAS", "points"}},
                        window_.get());
    dialog.setRobot("R1");
    dialog.setFolder(folder_->path());
    QStringList wanted;
    connect(&dialog, &ExportDialog::exportRequested, this, [&](const QStringList& ids) { wanted = ids; });
    showInFront(&dialog);
    QVERIFY(!dialog.isModal());
    QVERIFY(!button(dialog, "Export")->isEnabled()); // Nothing is chosen.
    dialog.setChosen({"ply", "no such format"});
    QCOMPARE(dialog.chosen(), QStringList{"ply"});
    QVERIFY(click(dialog, "GeoTIFF (.tif): heights"));
    QVERIFY(click(dialog, "Export"));
    QCOMPARE(wanted, (QStringList{"tif", "ply"}));
    QVERIFY(!dialog.isVisible());
    QCOMPARE(dialog.folder(), folder_->path());
}

USAR_TEST(tst_Dialogs)

} // namespace tst_dialogs

#include "tst_dialogs.moc"
