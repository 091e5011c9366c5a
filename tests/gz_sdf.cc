// The part of `gz sdf` that tests need, for systems with libsdformat but without the program.
#include <iostream>
#include <string>

#include <sdf/sdf.hh>

static int Print(const std::string &_file)
{
  auto sdf = std::make_shared<sdf::SDF>();
  sdf::Errors errors;
  if (!sdf::init(sdf) || !sdf::readFile(_file, sdf, errors))
    return 1;
  std::cout << sdf->Root()->ToString("");
  return 0;
}

static int Check(const std::string &_file)
{
  sdf::Root root;
  const bool isLoaded = root.Load(_file).empty() && root.Element();
  const bool isValid = isLoaded && sdf::checkCanonicalLinkNames(&root) &&
    sdf::checkJointParentChildLinkNames(&root) && sdf::checkFrameAttachedToGraph(&root) &&
    sdf::checkPoseRelativeToGraph(&root) && sdf::recursiveSiblingUniqueNames(root.Element()) &&
    sdf::recursiveSiblingNoDoubleColonInNames(root.Element());
  std::cout << (isValid ? "Valid." : "Not valid.") << std::endl;
  return isValid ? 0 : 1;
}

// Arguments as those of `gz`: sdf -p FILE, or sdf -k FILE.
int main(int _count, char **_arguments)
{
  if (_count != 4)
    return 2;
  return std::string(_arguments[2]) == "-k" ? Check(_arguments[3]) : Print(_arguments[3]);
}
