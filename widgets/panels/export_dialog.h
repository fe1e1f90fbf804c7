// Asks in which formats a map is to be exported, and into which folder.
#pragma once

#include <vector>

#include <QCheckBox>
#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QStringList>

namespace usar::widgets {

/// A format that may be chosen.
struct ExportOffer {
    QString id;
    QString title; ///< such as "GeoTIFF"
    QString use;   ///< what is in it, and who reads it
};

/// Tells the user's wish by signals and writes nothing itself. Not modal; Escape closes it. GUI thread.
class ExportDialog : public QDialog {
    Q_OBJECT
public:
    ExportDialog(const std::vector<ExportOffer>& offers, QWidget* parent);

    /// Says whose map it is.
    void setRobot(const QString& name);
    void setFolder(const QString& path);
    QString folder() const { return folder_->text(); }
    /// Checks these formats and no others.
    void setChosen(const QStringList& ids);
    /// Ids of the checked formats, in the order of the offers.
    QStringList chosen() const;

signals:
    void folderRequested();
    /// At least one format is chosen; the dialog is closed.
    void exportRequested(const QStringList& ids);

private:
    void lay();
    void refresh();

    std::vector<QCheckBox*> boxes_; ///< in the order of the offers; their object names are the ids
    QLabel* words_;
    QLabel* folder_;
    QPushButton* choose_folder_ = new QPushButton(tr("Change…"), this);
    QPushButton* export_ = new QPushButton(tr("Export"), this);
    QPushButton* close_ = new QPushButton(tr("Close"), this);
};

} // namespace usar::widgets
