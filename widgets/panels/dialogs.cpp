#include "widgets/panels/dialogs.h"

#include <utility>

#include <QClipboard>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QInputDialog>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QRegularExpression>
#include <QSpinBox>

#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

void showInFront(QDialog* dialog) {
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

namespace {

/// The open dialog with this title; nullptr if there is none.
template <class Dialog>
Dialog* openOne(QWidget* parent, const QString& title) {
    for (QDialog* const dialog : parent->findChildren<QDialog*>(title, Qt::FindDirectChildrenOnly))
        if (dialog->isVisible())
            return dynamic_cast<Dialog*>(dialog);
    return nullptr;
}

/// Shows the number or text dialog of that title; `prepare` is called with a new one.
template <class Answer, class Take>
void askByInput(QWidget* parent, const QString& title, const QString& label, Answer answered, Take take,
                const std::function<void(QInputDialog&)>& prepare) {
    auto* dialog = openOne<QInputDialog>(parent, title);
    if (!dialog) {
        dialog = new QInputDialog(parent);
        dialog->setObjectName(title);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->setWindowTitle(title);
        dialog->setLabelText(label);
        prepare(*dialog);
    }
    QObject::disconnect(dialog, answered, nullptr, nullptr);
    QObject::connect(dialog, answered, parent, std::move(take));
    showInFront(dialog);
}

void askForText(QWidget* parent, const QString& title, const QString& label, TakePath take) {
    askByInput(parent, title, label, &QInputDialog::textValueSelected, std::move(take),
               [](QInputDialog& dialog) { dialog.setInputMode(QInputDialog::TextInput); });
}

/// Qt's own file dialog. It opens message boxes that block the whole program, so this one asks and tells by itself
/// before Qt would, and is read only, because Qt would ask about renaming and deleting, too.
class PathDialog : public QFileDialog {
    Q_DECLARE_TR_FUNCTIONS(PathDialog)
public:
    PathDialog(QWidget* parent, const QString& title) : QFileDialog(parent, title) {
        setObjectName(title);
        setAttribute(Qt::WA_DeleteOnClose);
        setOption(DontUseNativeDialog);
        setOption(DontConfirmOverwrite);
        setOption(ReadOnly);
        connect(this, &QFileDialog::filesSelected, this, [this](const QStringList& paths) {
            for (const QString& path : paths)
                take_(QDir::cleanPath(path));
        });
    }

    void setTake(TakePath take) { take_ = std::move(take); }
    void beginAt(const QString& path) {
        if (QFileInfo(path).isDir())
            setDirectory(path);
        else if (!path.isEmpty())
            selectFile(path);
    }
    /// Adds a button that makes a folder, because a dialog that is read only has none.
    void offerNewFolder() {
        auto* const button = findChild<QDialogButtonBox*>()->addButton(tr("New folder…"), QDialogButtonBox::ActionRole);
        connect(button, &QPushButton::clicked, this, [this] {
            askForText(this, tr("New folder"), tr("Name of the new folder"),
                       [this](const QString& name) { makeFolder(name); });
        });
    }
    /// Sets the names of the filters; the chosen one gives a typed name its suffix.
    void setFilters(const QString& filters) {
        const QStringList names = filters.split(QStringLiteral(";;"));
        setNameFilters(names);
        connect(this, &QFileDialog::filterSelected, this, &PathDialog::takeSuffixOf);
        takeSuffixOf(names.front());
    }

protected:
    void accept() override {
        const QFileInfo file(selectedFiles().value(0));
        if (acceptMode() == AcceptSave && file.isFile())
            return ask(tr("%1 exists already. Replace it?").arg(file.fileName()), tr("Replace"),
                       [this, path = file.filePath()] { replace(path); });
        if (acceptMode() == AcceptOpen && !file.exists())
            return ask(tr("%1 does not exist. Choose another one.").arg(file.fileName()));
        finish();
    }

private:
    void finish() { QFileDialog::accept(); }

    /// Another file may have been chosen while the question was open; it is asked about in turn.
    void replace(const QString& path) { selectedFiles().value(0) == path ? finish() : accept(); }

    void makeFolder(const QString& name) {
        if (!directory().mkpath(name))
            return ask(tr("%1 cannot be created here. Choose another place.").arg(name));
        setDirectory(directory().filePath(name));
    }

    void takeSuffixOf(const QString& filter) {
        setDefaultSuffix(QRegularExpression(QStringLiteral("\\.(\\w+)")).match(filter).captured(1));
    }

    /// Says something; if there is an answer other than closing, it calls `run`.
    void ask(const QString& text, const QString& answer = {}, const std::function<void()>& run = {}) {
        if (question_) {
            question_->hide();
            question_->deleteLater(); // One of its buttons may be what was clicked.
        }
        question_ = new QMessageBox(QMessageBox::Warning, windowTitle(), text, QMessageBox::NoButton, this);
        question_->setAttribute(Qt::WA_DeleteOnClose);
        question_->setModal(false); // A message box is modal unless it is told otherwise.
        if (run)
            connect(question_->addButton(answer, QMessageBox::AcceptRole), &QPushButton::clicked, this, run);
        question_->setEscapeButton(question_->addButton(run ? QMessageBox::Cancel : QMessageBox::Close));
        question_->show();
    }

    TakePath take_;
    QPointer<QMessageBox> question_; ///< null: none is open
};

void askForPath(QWidget* parent, const QString& title, const std::function<void(PathDialog&)>& prepare, TakePath take) {
    auto* dialog = openOne<PathDialog>(parent, title);
    if (!dialog) {
        dialog = new PathDialog(parent, title);
        prepare(*dialog);
    }
    dialog->setTake(std::move(take));
    showInFront(dialog);
}

void askForExisting(QWidget* parent, const QString& title, const QString& begin, const QString& filters,
                    QFileDialog::FileMode mode, TakePath take) {
    const auto prepare = [&](PathDialog& dialog) {
        dialog.setFileMode(mode);
        dialog.setFilters(filters);
        dialog.beginAt(begin);
    };
    askForPath(parent, title, prepare, std::move(take));
}

} // namespace

void askForFile(QWidget* parent, const QString& title, const QString& begin, const QString& filters, TakePath take) {
    askForExisting(parent, title, begin, filters, QFileDialog::ExistingFile, std::move(take));
}

void askForFiles(QWidget* parent, const QString& title, const QString& begin, const QString& filters, TakePath take) {
    askForExisting(parent, title, begin, filters, QFileDialog::ExistingFiles, std::move(take));
}

void askForFolder(QWidget* parent, const QString& title, const QString& begin, TakePath take) {
    const auto prepare = [&](PathDialog& dialog) {
        dialog.setFileMode(QFileDialog::Directory);
        dialog.setOption(QFileDialog::ShowDirsOnly);
        dialog.offerNewFolder();
        dialog.setDirectory(QFileInfo(begin).isDir() ? begin : QFileInfo(begin).path());
    };
    askForPath(parent, title, prepare, std::move(take));
}

void askWhereToSave(QWidget* parent, const QString& title, const QString& proposal, const QString& filters,
                    TakePath take) {
    const auto prepare = [&](PathDialog& dialog) {
        dialog.setAcceptMode(QFileDialog::AcceptSave);
        dialog.offerNewFolder();
        dialog.setFilters(filters);
        dialog.beginAt(proposal);
    };
    askForPath(parent, title, prepare, std::move(take));
}

void askForNumber(QWidget* parent, const QString& title, const QString& label, int value, int least, int most,
                  std::function<void(int)> take, const QString& least_means) {
    askByInput(parent, title, label, &QInputDialog::intValueSelected, std::move(take), [=](QInputDialog& dialog) {
        dialog.setInputMode(QInputDialog::IntInput);
        dialog.setIntRange(least, most);
        dialog.setIntValue(value);
        if (auto* const box = dialog.findChild<QSpinBox*>())
            box->setSpecialValueText(least_means);
    });
}

ReportDialog::ReportDialog(const QString& title, const QString& text, QWidget* parent)
    : QDialog(parent)
    , text_(new QPlainTextEdit(text, this)) {
    setWindowTitle(title);
    text_->setReadOnly(true);
    text_->setLineWrapMode(QPlainTextEdit::NoWrap); // Keeps columns of figures aligned.
    text_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    text_->setAccessibleName(title);
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* const copied = buttons->addButton(tr("&Copy"), QDialogButtonBox::ActionRole);
    copied->setToolTip(tr("Copies the selected text, or all of it, to the clipboard"));
    auto* const saved = buttons->addButton(tr("&Save…"), QDialogButtonBox::ActionRole);
    saved->setToolTip(tr("Saves as text, or as JSON lines for other programs"));
    connect(copied, &QPushButton::clicked, this, &ReportDialog::copy);
    connect(saved, &QPushButton::clicked, this, &ReportDialog::saveRequested);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    laidOut(new QVBoxLayout(this), gap::small, {text_, buttons})->setStretchFactor(text_, 1);
}

void ReportDialog::copy() {
    if (text_->textCursor().hasSelection())
        text_->copy();
    else
        QGuiApplication::clipboard()->setText(text());
}

} // namespace usar::widgets
