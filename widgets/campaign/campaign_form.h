// The form that sets up a campaign from the mission that is set up: seeds, behaviors, one parameter, faults.
#pragma once

#include <vector>

#include <QAction>
#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QScrollArea>
#include <QSpinBox>
#include <QToolButton>

#include "widgets/style/form_parts.h"

namespace usar::widgets {

class QuantityBox;

/// A behavior that can fly the mission.
struct CampaignBehavior {
    QString id;
    QString name;
    bool operator==(const CampaignBehavior&) const = default;
};

/// A number of the behavior that can have several values.
struct CampaignParameter {
    QString id;
    QString label;
    QString unit;  ///< It is the unit in which the values are typed; empty if there is none.
    QString usual; ///< The mission has this value.
    bool operator==(const CampaignParameter&) const = default;
};

enum class CampaignFaults { None, OfTheDock, Swarm };

/// What the fields say.
struct CampaignWish {
    int first_seed = 1;
    int seeds = 1;
    QStringList behaviors; ///< They are told by their ids.
    QString parameter;     ///< It is empty if none is varied.
    QString values;        ///< They are as they were typed.
    CampaignFaults faults = CampaignFaults::None;
    double swarm_share = 0.3;
    int jobs = 1;
    QString folder; ///< The results are kept there.
};

/// State comes in by setters, wishes go out by signals. With a campaign from a file only the number of missions at a
/// time and the folder can be chosen. Made for a narrow dock. GUI thread.
class CampaignForm : public QWidget {
    Q_OBJECT
public:
    explicit CampaignForm(QWidget* parent = nullptr);

    /// Names the mission that the campaign is made from; `trouble` says why there is none, or is empty.
    void setMission(const QString& mission, const QString& trouble);
    /// The behaviors to choose from; those with the same ids stay checked, else only `usual` is.
    void setBehaviors(const std::vector<CampaignBehavior>& behaviors, const QString& usual);
    /// The chosen parameter stays chosen if it is among them.
    void setParameters(const std::vector<CampaignParameter>& parameters);
    /// Says how many faults the Faults dock has now.
    void setFaultCount(int count);
    void setFolder(const QString& folder);
    /// Says that the campaign is that of a file; empty: it is set up here.
    void setFile(const QString& words);

    CampaignWish wish() const;
    /// Shows a sentence about what is wrong with the fields; empty: nothing is.
    void setTrouble(const QString& trouble);
    void setActions(QAction* run, QAction* save, QAction* open, QAction* open_folder);
    QSize sizeHint() const override { return {300, 420}; }

protected:
    /// A wide form has two columns.
    void resizeEvent(QResizeEvent* event) override;

signals:
    /// A field was changed.
    void changed();
    /// The user wants to choose the folder in a dialog.
    void folderWanted();
    /// The user wants to set up a campaign in place of the one from a file.
    void ownCampaignWanted();

private:
    void makeSeeds();
    void makeBehaviors();
    void makeParameter();
    void makeFaults();
    void makePlaces();
    void alignLabels();
    void makeButtons();
    void placeButtons(bool wide);
    void showFields();
    void showTrouble();

    QBoxLayout* columns_;
    QFormLayout* what_;  ///< It is the first column: what is flown.
    QFormLayout* where_; ///< It is the second column: what goes wrong, and where the results are kept.
    QScrollArea* scroll_ = nullptr;
    QWidget* button_box_ = new QWidget(this);
    QGridLayout* buttons_;
    ElidedLabel* mission_ = new ElidedLabel(this);
    QSpinBox* first_seed_ = new QSpinBox(this);
    QSpinBox* seeds_ = new QSpinBox(this);
    QWidget* seed_row_ = new QWidget(this);
    QListWidget* behaviors_ = new QListWidget(this);
    QComboBox* parameter_ = new QComboBox(this);
    QLineEdit* values_ = new QLineEdit(this);
    QComboBox* faults_ = new QComboBox(this);
    QuantityBox* share_;
    QSpinBox* jobs_ = new QSpinBox(this);
    QLineEdit* folder_ = new QLineEdit(this);
    QToolButton* browse_;
    QPushButton* own_ = new QPushButton(tr("Set up one here"), this);
    QLabel* trouble_ = new QLabel(this);
    QPushButton* run_ = new QPushButton(tr("Run campaign"), this);
    QPushButton* save_ = new QPushButton(tr("Save…"), this);
    QPushButton* open_ = new QPushButton(tr("Open…"), this);
    QPushButton* open_folder_ = new QPushButton(tr("Results…"), this);
    QString mission_trouble_;
    QString field_trouble_;
    QString file_; ///< It is empty if the campaign is set up here.
    std::vector<CampaignParameter> parameters_;
    std::vector<CampaignBehavior> known_behaviors_;
};

} // namespace usar::widgets
