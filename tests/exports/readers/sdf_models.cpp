// Reads an SDF file with libsdformat; prints its errors, and of each model its name, pose and mass: one a line, tabs between.
#include <iomanip>
#include <iostream>
#include <sdf/sdf.hh>

int main(int, char **arguments) {
  sdf::Root root;
  const sdf::Errors errors = root.Load(arguments[1]);
  for (const sdf::Error &error : errors) std::cerr << error << "\n";
  if (!errors.empty()) return 1;
  const sdf::World *world = root.WorldByIndex(0);
  std::cout << std::setprecision(9);
  for (uint64_t i = 0; i < world->ModelCount(); ++i) {
    const sdf::Model *model = world->ModelByIndex(i);
    const auto pose = model->RawPose();
    const double mass = model->LinkByIndex(0)->Inertial().MassMatrix().Mass();
    std::cout << model->Name() << "\t" << pose.X() << "\t" << pose.Y() << "\t" << pose.Z() << "\t" << pose.Yaw() << "\t" << mass
              << "\t" << model->Static() << "\t" << model->JointCount() << "\n";
  }
  return 0;
}
