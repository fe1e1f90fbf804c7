// Input for raw commands: completion from the grammar, history, and error messages with their column.
#pragma once

#include <QCompleter>
#include <QLabel>
#include <QPushButton>
#include <QStandardItemModel>
#include <QTimer>
#include <QWidget>

#include "widgets/messages/command_line.h"
#include "widgets/models/messages/line_history.h"

namespace usar::widgets {

/// Enter sends the line. A line with an error is sent only by a second Enter; a warning (such as an unknown word) does
/// not prevent sending. Tab accepts a completion; Up and Down walk through the lines of the history that contain the
/// typed text. GUI thread.
class CommandBox : public QWidget {
    Q_OBJECT
public:
    explicit CommandBox(QWidget* parent = nullptr);

    /// Name of the robot that gets the line ("R1"; empty: no connection), and the reason why nothing can be sent; an
    /// empty `refusal` means that sending is possible.
    void setTarget(const QString& name, const QString& refusal);
    /// Sent lines, oldest first.
    QStringList history() const { return history_.lines(); }
    void setHistory(const QStringList& lines) { history_.setLines(lines); }
    /// Shows a sentence under the line until the text changes.
    void complain(Severity severity, const QString& sentence);
    /// The line edit; owned by the box.
    CommandLine* line() const { return line_; }
    /// The sentence shown under the line; empty if there is none.
    QString complaint() const { return complaint_->isHidden() ? QString() : complaint_->text(); }
    /// Offers the completions that fit at the cursor; owned by the box.
    const QCompleter* completer() const { return completer_; }
    /// Opens the list of everything that may follow at the cursor.
    void openCompletions();

signals:
    /// The line to send, trimmed and without a line end.
    void sendRequested(const QString& line);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void setUpCompleter();
    /// The text was edited: ends the walk through the history and opens the completions.
    void takeEdit();
    /// Handles Enter, Tab, the arrow keys and Ctrl+Space; returns true if the key was used.
    bool takeKey(int key, Qt::KeyboardModifiers modifiers);
    bool popupOpen() const;
    /// True if an entry of the completion list is marked.
    bool chosenInPopup() const;
    /// Accepts the marked completion, or the first one. Returns true.
    bool acceptFirst();
    void accept(const QModelIndex& index);
    /// Marks and shows what is wrong; without `all` it skips the word that is still being typed.
    Diagnostics check(bool all);
    void send();

    LineHistory history_;
    CommandLine* line_ = new CommandLine(this);
    QPushButton* send_ = new QPushButton(tr("Send"), this);
    QLabel* complaint_ = new QLabel(this);
    QCompleter* completer_ = new QCompleter(this);
    QStandardItemModel* completions_ = new QStandardItemModel(this);
    QTimer idle_{this};
    QString refusal_;
    QString sent_anyway_; ///< a second Enter sends this line in spite of its errors
};

} // namespace usar::widgets
