# Stands for another program: prints the error it is told and a time.
echo "error = $1"
echo "seconds = 0.25 s"
