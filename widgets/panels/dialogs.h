// Dialogs that ask for files, folders and numbers without stopping anything else, and one that shows a long text.
#pragma once

#include <functional>

#include <QDialog>
#include <QPlainTextEdit>
#include <QWidget>

namespace usar::widgets {

/// Takes the path that the user chose. It is not called if the user cancels.
using TakePath = std::function<void(const QString& path)>;

/// Each of the next functions shows a dialog beside `parent` and returns at once; none is modal, because a robot may be
/// moving and the stop must remain within reach. There is one dialog for a title: another request raises the open one,
/// and the answer goes to the newest request. `filters`: as for QFileDialog.

/// Asks for a file that exists. `begin`: the folder that is shown first, or the file that is offered; may be empty.
void askForFile(QWidget* parent, const QString& title, const QString& begin, const QString& filters, TakePath take);
/// The same for one file or several at once; `take` is called with each of them, in the order of the list.
void askForFiles(QWidget* parent, const QString& title, const QString& begin, const QString& filters, TakePath take);
/// Asks for a folder; the user can make a new one. `begin`: as in `askForFile`.
void askForFolder(QWidget* parent, const QString& title, const QString& begin, TakePath take);
/// Asks for the name of a file to write; asks again before an existing one is replaced. `proposal`: name or path that
/// is offered. A name that is typed without a suffix gets that of the chosen filter, that is, the filter's first one.
void askWhereToSave(QWidget* parent, const QString& title, const QString& proposal, const QString& filters,
                    TakePath take);
/// Shows a dialog that is not modal, and brings it in front.
void showInFront(QDialog* dialog);
/// Asks for a whole number within `least` and `most`. `least_means`: what the box shows for the least; empty: the
/// number.
void askForNumber(QWidget* parent, const QString& title, const QString& label, int value, int least, int most,
                  std::function<void(int)> take, const QString& least_means = {});

/// Only asks for saving; the window chooses the file. GUI thread.
class ReportDialog : public QDialog {
    Q_OBJECT
public:
    ReportDialog(const QString& title, const QString& text, QWidget* parent);

    /// The text that is shown, without formatting.
    QString text() const { return text_->toPlainText(); }
    QSize sizeHint() const override { return {900, 520}; }

signals:
    /// The user wants to save text().
    void saveRequested();

private:
    void copy();

    QPlainTextEdit* text_;
};

} // namespace usar::widgets
